#pragma once
#include <type_traits>
#include <utility>

#include "chapters/04_artificial_viscosity/viscosities.hpp"
#include "chapters/05_tensile_instability/scenes/solid.hpp"
#include "chapters/05_tensile_instability/scenes/solid_totals.hpp"
#include "common/core/motion.hpp"
#include "common/core/neighbours.hpp"
#include "common/core/pass.hpp"
#include "common/core/unstable.hpp"

namespace sph::tensile {

/// What a list of effects asks for.
template <class E, class Column>
inline constexpr bool reads = contains<typename E::ReadI, Column>;
template <class E, class Column>
inline constexpr bool stores = contains<typename E::Stored, Column>;

// [jaumann-solid]
/// A solid by (11.1)-(11.6). Strains: effects that make rates of rho and S (and x) of velocities; Forces:
/// effects that make accelerations of stresses. Each list is one pass over the pairs.
template <class Strains, class Forces, class Boundary>
class JaumannSolid : public Solid {
  public:
    using All = Union<List<Position, Velocity, Acceleration, Mass, Density, DensityRate, Pressure, Volume,
                           DeviatoricStress, StressRate, Stress>,
                      typename Strains::Stored, typename Forces::ReadI>;
    ParticlesOf<2, All> particles;
    // [end]

    JaumannSolid(const SolidSetup& setup, const ConstantH<SolidKernel>& smoothing, Boundary boundary,
                 Strains strains, Forces forces)
        : particles{setup.n},
          setup_{setup},
          smoothing_{smoothing},
          neighbours_{std::move(boundary), setup.threads},
          strains_{strains},
          forces_{forces},
          kicks_{neighbours_.team()},
          flows_{neighbours_.team()} {
        offer(particles);
        if constexpr (reads<Forces, SmoothingLength>) particles.h.assign(setup.n, smoothing.h);
        if constexpr (reads<Forces, SoundSpeed>) particles.c_s.assign(setup.n, setup.matter.sound_speed());
        kicks_.evolve<Velocity, Acceleration>(particles);
        flows_.evolve<Position, MovedBy>(particles)
            .template evolve<Density, DensityRate>(particles)
            .template evolve<DeviatoricStress, StressRate>(particles);
    }

    void start(double t) override {
        resolve(t);
        find_rates();
        find_forces();
    }
    /// Pressure, stress and artificial stress of density and S.
    void resolve(double) override {
        auto& p = particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.V[i] = p.m[i] / p.rho[i];
            p.p[i] = setup_.matter.pressure(p.rho[i]);
            Row<double, 2, Stress> stress{{load<2>(p, i, List<DeviatoricStress>{}).S}};
            for (std::size_t a = 0; a < 2; ++a) stress.sigma[a][a] -= p.p[i];
            store<2>(p, i, stress);
            if constexpr (reads<Forces, ArtificialStress>) {
                const auto R = artificial_stress<2>(stress.sigma, p.rho[i], setup_.epsilon);
                store<2>(p, i, Row<double, 2, ArtificialStress>{{R}});
            }
        }
    }
    double longest_step() override { return setup_.time_step(); }

    // [leapfrog]
    /// Leapfrog where stresses follow from velocities: half a kick; x, rho and S over the whole step with
    /// rates from its middle; forces; half a kick. Second order, one pass of each kind.
    bool step(double& t, double dt) override {
        require_time_step(t, dt);
        kicks_.kick(dt / 2);
        start_.save(flows_);
        start_.advance(flows_, dt / 2);  // with the rates of the last middle
        find_rates();
        start_.advance(flows_, dt);
        t += dt;
        flows_.require_physical(t);
        resolve(t);
        find_forces();
        kicks_.kick(dt / 2);
        kicks_.require_physical(t);
        return true;
    }
    // [end]

    /// Energy: of motion, of compression, and S:S/4 mu by volume, with the S of the third axis.
    Totals<2> totals() const override {
        const auto& p = particles;
        Totals<2> sum = totals_of_motion(p);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto S = load<2>(p, i, List<DeviatoricStress>{}).S;
            const double third = S[0][0] + S[1][1];
            const double squares = dot(S[0], S[0]) + dot(S[1], S[1]) + third * third;
            sum.energy += p.m[i] * (setup_.matter.compression_energy(p.rho[i]) +
                                    squares / (4 * setup_.matter.shear * p.rho[i]));
        }
        return sum;
    }
    Groups& groups() override { return particles.groups; }
    Counters& counters() override { return neighbours_.counters(); }

  private:
    using MovedBy = std::conditional_t<stores<Strains, TransportVelocity>, TransportVelocity, Velocity>;
    void find_rates() {
        neighbours_.find(particles.x, smoothing_.reach());
        for (std::size_t i = 0; i < particles.size(); ++i) particles.V[i] = particles.m[i] / particles.rho[i];
        sum_over_neighbours(particles, neighbours_, smoothing_, strains_);
    }
    void find_forces() {
        if constexpr (reads<Forces, MiddleVelocity>) particles.v_mid = particles.v;
        neighbours_.find(particles.x, smoothing_.reach());
        sum_over_neighbours(particles, neighbours_, smoothing_, forces_);
    }

    SolidSetup setup_;
    ConstantH<SolidKernel> smoothing_;
    Neighbours<2, Boundary> neighbours_;
    Strains strains_;
    Forces forces_;
    Motion kicks_, flows_;
    Motion::Saved start_;
};

}  // namespace sph::tensile
