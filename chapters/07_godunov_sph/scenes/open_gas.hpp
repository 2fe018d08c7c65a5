#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "chapters/03_euler_sph/equation_of_state.hpp"
#include "chapters/07_godunov_sph/walls.hpp"
#include "common/core/simulation.hpp"
#include "common/report/method.hpp"

/// Gases in the plane whose particles come and go.
namespace sph::godunov {

class OpenGas {
  public:
    virtual ~OpenGas() = default;
    virtual Simulation<2>& gas() = 0;
    /// Between two steps: particle k becomes a copy of what particle from[k] is, in all columns; there are as
    /// many as `from` has.
    virtual void take(const std::vector<std::uint32_t>& from) = 0;
};

template <class Gas>
class Opened final : public OpenGas {
  public:
    template <class... Arguments>
    explicit Opened(Arguments&&... arguments) : gas_{std::forward<Arguments>(arguments)...} {}
    Simulation<2>& gas() override { return gas_; }
    void take(const std::vector<std::uint32_t>& from) override {
        gas_.particles.for_each_column([&](auto, Column& column) {
            Column taken;
            taken.reserve(from.size());
            for (const std::uint32_t i : from) taken.push_back(column[i]);
            column = std::move(taken);
        });
        gas_.particles.resize(from.size());
        gas_.restart();
    }

  private:
    Gas gas_;
};

/// What a channel gives to any method.
struct ChannelSetup {
    std::size_t n;  ///< particles at the beginning
    ThermalState state;
    OpenChannel channel;
    double courant = 0.45;
    int threads = 1;
};
using ChannelMethod = report::Method<OpenGas, ChannelSetup>;
using ChannelMethods = report::Methods<ChannelMethod>;

/// `godunov`, the recommended one in the plane, `first-order`, the same without slopes, and
/// `geometric-volume`, that of the line; the paper's scheme as `inutsuka` and
/// `inutsuka-linear`; SPH with viscosity as `alpha-beta` and `alpha-beta-twice`.
const ChannelMethods& channel_methods();

}  // namespace sph::godunov
