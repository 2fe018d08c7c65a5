#pragma once
#include <cmath>
#include <utility>

#include "chapters/05_tensile_instability/scenes/solid.hpp"
#include "chapters/05_tensile_instability/scenes/solid_totals.hpp"
#include "chapters/05_tensile_instability/total_lagrangian.hpp"
#include "common/core/integrated.hpp"
#include "common/core/neighbours.hpp"
#include "common/core/pass.hpp"
#include "common/core/unstable.hpp"

namespace sph::tensile {

// [lagrangian-solid]
/// A total Lagrangian solid, by leapfrog. External: forces on particles one by one.
template <class Boundary, class... External>
class LagrangianSolid : public Integrated<2> {
  public:
    using All = Union<List<Position, Velocity, Acceleration, Mass, Density, Pressure, Volume, Displacement,
                           CorrectionMatrix, ReferenceStress, ElasticEnergy>,
                      typename Effects<External...>::ReadI>;
    ParticlesOf<2, All> particles;
    // [end]

    LagrangianSolid(const SolidSetup& setup, const ConstantH<SolidKernel>& smoothing, Boundary boundary,
                    External... external)
        : particles{setup.n},
          setup_{setup},
          smoothing_{smoothing},
          neighbours_{std::move(boundary), setup.threads},
          forces_{ReferenceForce{}, external...} {
        offer(particles);
        motion_ = Motion{neighbours_.team()};
        motion_.evolve<Displacement, Velocity>(particles).template evolve<Velocity, Acceleration>(particles);
        limit_steps([this] { return setup_.time_step(); });
    }
    // [start]
    /// The only search of a run, and the matrices B of the beginning.
    void start(double) override {
        auto& p = particles;
        begin_ = p.x;
        for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / setup_.matter.rho0;
        neighbours_.find(p.x, smoothing_.reach());
        sum_over_neighbours(p, neighbours_, smoothing_, Effects{CorrectionMatrix{}});
    }
    void rates(double t) override {
        sum_over_neighbours(particles, neighbours_, smoothing_, Effects{NeoHookean{setup_.matter}});
        require_physical(particles.elastic, ElasticEnergy::name, false, t);
        sum_over_neighbours(particles, neighbours_, smoothing_, forces_);
    }
    // [end]
    void resolve(double) override {
        auto& p = particles;
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t i = 0; i < p.size(); ++i) p.x[a][i] = begin_[a][i] + p.moved[a][i];
        }
    }
    Totals<2> totals() const override {
        Totals<2> sum = totals_of_motion(particles);
        for (const double one : particles.elastic) sum.energy += one;
        return sum;
    }
    Groups& groups() override { return particles.groups; }
    Counters& counters() override { return neighbours_.counters(); }

  private:
    SolidSetup setup_;
    ConstantH<SolidKernel> smoothing_;
    Neighbours<2, Boundary> neighbours_;
    Columns<2> begin_;
    Effects<ReferenceForce, External...> forces_;
};

}  // namespace sph::tensile
