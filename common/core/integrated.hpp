#pragma once
#include <functional>
#include <memory>
#include <utility>

#include "common/core/integrators.hpp"
#include "common/core/simulation.hpp"

namespace sph {

/// A simulation that knows its rates, and whose steps an integrator makes: KickDriftKick, unless another one
/// is named.
template <int d>
class Integrated : public Simulation<d> {
  public:
    /// The rates of all that evolves, at the particles' present state.
    virtual void rates(double t) = 0;
    const Motion& motion() const { return motion_; }

    /// Steps by the integrator I(motion, rates, more...) from now on.
    template <class I, class... More>
    I& integrate_by(More&&... more) {
        auto one = std::make_unique<I>(
            motion_, [this](double t) { rates(t); }, std::forward<More>(more)...);
        I& reference = *one;
        integrator_ = std::move(one);
        return reference;
    }
    /// What longest_step() says; without it, it is what the integrator says.
    void limit_steps(std::function<double()> limit) { limit_ = std::move(limit); }

    double longest_step() override { return limit_ ? limit_() : integrator().longest_step(); }
    bool step(double& t, double dt) override { return integrator().step(t, dt); }
    void restart() override { integrator().restart(); }

  protected:
    Motion motion_;

  private:
    Integrator& integrator() {
        if (!integrator_) integrate_by<KickDriftKick>();
        return *integrator_;
    }
    std::unique_ptr<Integrator> integrator_;
    std::function<double()> limit_;
};

}  // namespace sph
