#pragma once
#include "chapters/03_euler_sph/gas.hpp"

/// A liquid that can be pulled: pressure below zero is tension. What a cure adds to it is a type of its own.
namespace sph {

/// p = P + c^2 (rho - rho_0): the pressure is P where the density is rho_0, and sound has the speed c at all
/// densities. P any, P < 0 is tension; c > 0, rho_0 > 0. The energy by mass counts from rho = rho_0.
struct Liquid {
    double P, c, rho_0;
    double pressure(double rho) const { return P + c * c * (rho - rho_0); }
    double sound_speed(double) const { return c; }
    double energy(double rho) const {
        return (P - c * c * rho_0) * (1 / rho_0 - 1 / rho) + c * c * std::log(rho / rho_0);
    }
};

/// The force (3.8) and nothing else: the scheme that the chapter begins with, and the form of all others. A
/// cure gives
///     Columns    what its particles carry besides Position, Velocity, Acceleration, Mass, Density, Pressure
///     Drift      the column that positions move with: Velocity, or one of its own (XSPH, transport)
///     effects()  what the pass of the forces sums
/// and may have, each called with the particles p, and `sum`, which makes a pass over the pairs for the
/// effects that it gets:
///     evolve(motion, p)         more equations in time
///     start(p)                  once, at the state that the scene begins with
///     resolved(p, sum)          after density and pressure are known, before the forces: other passes
///     moved(p, sum, dt)         after each step of length dt, at the positions that it has left; p may be
///                               changed, positions too: neighbours are then searched anew
///     energy(p, i)              what it has stored, by mass, besides that of the equation of state
struct Uncured {
    using Columns = List<>;
    using Drift = Velocity;
    auto effects() const { return Effects{PressureForce<>{}}; }
};

/// A resolution whose density evolves by what the cure says; a place finds its neighbours and no more.
template <class K>
struct EvolvedDensity : FixedH<K> {
    using Columns = List<DensityRate>;
    void evolve(Motion& motion, auto& particles) const {
        motion.template evolve<Density, DensityRate>(particles);
    }
    template <class P, class N>
    void resolve(P& particles, N& neighbours) const {
        neighbours.find(particles.x, this->smoothing().reach());
    }
};

/// Particles of a liquid whose density, smoothing and boundary the Resolution and Boundary give (gas.hpp),
/// with a Cure.
template <class Resolution, class Boundary, class Cure = Uncured>
class CuredLiquid
    : public Smoothed<Integrated, Resolution, Boundary, Union<List<Acceleration>, typename Cure::Columns>> {
    using Base =
        Smoothed<Integrated, Resolution, Boundary, Union<List<Acceleration>, typename Cure::Columns>>;

  public:
    static constexpr int d = Base::d;
    using Base::particles;

    CuredLiquid(std::size_t n, Resolution resolution, Liquid state, Boundary boundary, int threads,
                Cure cure = {})
        : Base{n, std::move(resolution), std::move(boundary), threads},
          state_{state},
          cure_{std::move(cure)} {
        Motion& motion = this->motion_ = Motion{this->team()};
        motion.template evolve<Position, typename Cure::Drift>(particles)
            .template evolve<Velocity, Acceleration>(particles);
        this->resolution_.evolve(motion, particles);
        if constexpr (requires { cure_.evolve(motion, particles); }) cure_.evolve(motion, particles);
        motion.watch(particles);
    }

    void start(double) override {
        this->resolution_.start(particles);
        if constexpr (requires { cure_.start(particles); }) cure_.start(particles);
    }
    void resolve(double t) override {
        this->find_density(t);
        for (std::size_t i = 0; i < particles.size(); ++i) particles.p[i] = state_.pressure(particles.rho[i]);
        const auto sum = summing();
        if constexpr (requires { cure_.resolved(particles, sum); }) cure_.resolved(particles, sum);
    }
    // [rates]
    void rates(double t) override {
        resolve(t);
        this->sum(cure_.effects());
        if constexpr (requires { this->resolution_.rates(); }) this->sum(this->resolution_.rates());
    }
    bool step(double& t, double dt) override {
        if (!Base::step(t, dt)) return false;
        const auto sum = summing();
        if constexpr (requires { cure_.moved(particles, sum, dt); }) {
            this->find_density(t);
            cure_.moved(particles, sum, dt);
            this->restart();
        }
        return true;
    }
    // [end]
    /// sum m, sum m v, and sum m (v^2/2 + e), at a resolved state.
    Totals<d> totals() const override {
        Totals<d> sum;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const auto row = load<d>(particles, i, List<Velocity>{});
            double by_mass = 0.5 * dot(row.v, row.v) + state_.energy(particles.rho[i]);
            if constexpr (requires { cure_.energy(particles, i); }) by_mass += cure_.energy(particles, i);
            sum.mass += particles.m[i];
            sum.momentum += particles.m[i] * row.v;
            sum.energy += particles.m[i] * by_mass;
        }
        return sum;
    }
    const Liquid& state() const { return state_; }
    const Cure& cure() const { return cure_; }

  private:
    auto summing() {
        return [this](const auto& effects) { this->sum(effects); };
    }

    Liquid state_;
    Cure cure_;
};

}  // namespace sph
