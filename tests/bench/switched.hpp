#pragma once
#include <memory>
#include <vector>

#include "chapters/01_kernel_interpolation/scenes/naive.hpp"
#include "tests/bench/gas.hpp"

/// The same effects, chosen at run time: by ifs and by virtual calls, for each tile of eight pairs and for
/// each pair. What is switched off still has its columns read and its sums cleared and stored, as in a code
/// that is compiled once for all scenes.
namespace bench {

struct Switches {
    bool density = false, continuity = false, pressure = false, heating = false, viscosity = false;
    friend constexpr bool operator==(const Switches&, const Switches&) = default;
};

/// One effect that holds all five behind ifs.
struct SwitchedTiles {
    Switches on;
    using Reads = sph::List<sph::Velocity, sph::Density, sph::Pressure, sph::SoundSpeed>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Density, sph::DensityRate, sph::Acceleration, sph::Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        if (on.density) sph::SummedDensity{}.add(i, j, pair, sum);
        if (on.continuity) Continuity{}.add(i, j, pair, sum);
        if (on.pressure) PressureForce{}.add(i, j, pair, sum);
        if (on.heating) PressureHeating{}.add(i, j, pair, sum);
        if (on.viscosity) ArtificialViscosity{}.add(i, j, pair, sum);
    }
};

/// Five objects behind virtual calls, each with a tile of pairs.
class VirtualTiles {
  public:
    using Reads = SwitchedTiles::Reads;
    using ReadsJ = SwitchedTiles::ReadsJ;
    using Adds = SwitchedTiles::Adds;
    using I = sph::Row<double, 3, sph::Velocity, sph::Density, sph::Pressure, sph::SoundSpeed>;
    using J = sph::pass_detail::Neighbour<3, sph::Velocity, sph::Density, sph::Pressure, sph::SoundSpeed,
                                          sph::Mass>;
    using Pair = sph::Pair<3, double>;
    using Sum = sph::Row<sph::Tile, 3, sph::Density, sph::DensityRate, sph::Acceleration, sph::Heating>;
    struct Effect {
        virtual ~Effect() = default;
        virtual void add(const I& i, const J& j, const Pair& pair, Sum& sum) const = 0;
    };

    explicit VirtualTiles(Switches on);
    void add(const I& i, const J& j, const Pair& pair, Sum& sum) const {
        for (const auto& effect : effects_) effect->add(i, j, pair, sum);
    }

  private:
    std::vector<std::shared_ptr<const Effect>> effects_;  // shared: a pass copies its effects
};

/// Sorted structures and a ready list, one pair at a time.
class OnePairAtATime {
  public:
    OnePairAtATime(const Gas<3>& gas, Switches on);
    void listed();              ///< compiled for the switches that are on
    void with_ifs();            ///< an if for each effect of each pair
    void with_virtual_calls();  ///< a virtual call for each effect of each pair

    struct Particle {
        double x[3], v[3], m, rho, p, c_s;
        double rho_sum, drho_dt, dv_dt[3], du_dt;
    };
    struct Terms {
        double x[3], W, F, approach, h;
    };
    struct Effect {
        virtual ~Effect() = default;
        virtual void add(Particle& i, const Particle& j, const Terms& pair) const = 0;
    };

  private:
    template <class Add>
    void for_each_pair(Add&& add);
    template <Switches on>
    void listed_for();

    double h_;
    Switches on_;
    std::vector<Particle> particles_;
    std::vector<std::uint32_t> receiver_, list_;
    std::vector<std::size_t> start_;
    std::vector<std::unique_ptr<const Effect>> effects_;
};

}  // namespace bench
