#pragma once
#include "chapters/08_landau_model/baryon_state.hpp"
#include "chapters/08_landau_model/relativistic_dissipation.hpp"

/// A relativistic gas of baryons that can pass shocks.
namespace sph {

/// A way to dissipate: the sums for its slopes, and what its pairs exchange, both as lists of effects.
struct NoScheme {
    using Slopes = List<>;
    Effects<> exchange{};
};
struct ChowMonaghanScheme {
    using Slopes = List<>;
    Effects<ChowMonaghan> exchange{ChowMonaghan{}};
};
struct ReconstructedScheme {
    using Slopes = List<SlopeMatrix, RapiditySlope, RapidityGradient, PressureSlope, PressureGradient>;
    Effects<ReconstructedExchange, ContactConduction> exchange{ReconstructedExchange{}, ContactConduction{}};
};

/// q and E evolve, h and N = sum nu W are solved as in chapter 3, v and P recovered (baryon_state.hpp). Steps
/// of second order with one evaluation of the forces, in the middle:
///     x' = x + dt/2 v,  q', E' with the rates of the last middle;   x += dt v',  q += dt dq/dt',  E += dt
///     dE/dt'.
/// Totals of q and E stand still to rounding. In one dimension; particles from moving() on keep v, q and E.
template <class Kernel, class Scheme>
class RelativisticGas {
  public:
    static constexpr int d = 1;
    using P =
        ParticlesOf<d,
                    Union<List<Position, Velocity, Momentum, Acceleration, EnergyPerBaryon, EnergyRate, Mass,
                               Density, Pressure, SoundSpeed, ThermalEnergy, Enthalpy, Rapidity, StepRate>,
                          typename ConsistentH<Kernel>::Columns, typename Scheme::Slopes>>;

    P particles;

    RelativisticGas(std::size_t n, HRule rule, double gamma, int threads)
        : particles{n}, resolution_{rule, close_}, gamma_{gamma}, neighbours_{Free{}, threads} {}

    /// Density, smoothing length, velocity and pressure at the present state. Throws Unstable at time t.
    void resolve(double t) {
        find_density(t);
        const std::size_t wrong = recover_all();
        if (wrong < particles.size())
            throw Unstable{t, wrong, EnergyPerBaryon::name.data(), particles.E[wrong]};
    }
    /// Moves on to `end` in steps of `courant` over the largest LabSignalRate, none more than twice the one
    /// before. A step whose middle would allow less than half of it, or that leaves a particle without
    /// thermal energy, is done again with half the length, at most 20 times. Calls after_step(t).
    template <class AfterStep>
    void advance(double& t, double end, double courant, AfterStep&& after_step);

    /// sum nu E and sum nu q of the moving particles, less what the fixed ones have given: constant but for
    /// rounding.
    double energy() const { return total(particles.E) + given_E_; }
    double momentum() const { return total(particles.q[0]) + given_q_; }
    Counters& counters() { return neighbours_.counters(); }

  private:
    static constexpr double close_ = 1e-4;  // conservation does not hang on h: see chapter 4
    static constexpr int most_retries = 20;

    void find_density(double t);
    std::size_t recover_all();
    void sum_rates();
    bool step(double t, double dt, double courant);
    double largest_rate() const {
        return *std::max_element(particles.step_rate.begin(), particles.step_rate.end());
    }
    double total(const Column& value) const {
        double sum = 0;
        for (std::size_t i = 0; i < particles.moving(); ++i) sum += particles.m[i] * value[i];
        return sum;
    }
    template <class... Slope>
    void find_slopes(List<Slope...>) {
        if constexpr (sizeof...(Slope) > 0)
            sum_over_neighbours(particles, neighbours_, resolution_.smoothing(), Effects{Slope{}...});
    }

    ConsistentH<Kernel> resolution_;
    Scheme scheme_{};
    double gamma_;
    Neighbours<d> neighbours_;
    bool started_ = false;
    P start_;
    double last_dt_ = std::numeric_limits<double>::infinity();
    double given_q_ = 0, given_E_ = 0;
};

template <class K, class S>
void RelativisticGas<K, S>::find_density(double t) {
    try {
        resolution_.resolve(particles, neighbours_);
    } catch (const Unstable& failure) {
        throw Unstable{t, failure.particle, failure.quantity, failure.value};
    } catch (const std::invalid_argument&) {  // a position or h that is not a number: say when and whose
        require_physical(particles, t, typename P::Names{});
        throw;
    }
}

/// The first particle that no state belongs to; how many there are if all are sound.
template <class K, class S>
std::size_t RelativisticGas<K, S>::recover_all() {
    P& p = particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const BaryonState state = recover_baryons(p.q[0][i], p.E[i], p.rho[i], gamma_, p.p[i]);
        if (!state.sound) return i;
        p.v[0][i] = state.v, p.y[i] = std::asinh(state.four_velocity);
        p.p[i] = state.p, p.u[i] = state.u, p.c_s[i] = state.c_s, p.h_enthalpy[i] = state.h;
    }
    return p.size();
}

template <class K, class S>
void RelativisticGas<K, S>::sum_rates() {
    find_slopes(typename S::Slopes{});
    std::apply(
        [&](const auto&... exchange) {
            sum_over_neighbours(particles, neighbours_, resolution_.smoothing(),
                                Effects{GradHForce{}, GradHWork{}, exchange..., LabSignalRate{}});
        },
        scheme_.exchange.list);
}

/// One step; false if it must be shorter, and then all is as before.
template <class K, class S>
bool RelativisticGas<K, S>::step(double t, double dt, double courant) {
    P& p = particles;
    start_ = p;
    const auto move = [&](double by) {
        for (std::size_t i = 0; i < p.size(); ++i) p.x[0][i] = start_.x[0][i] + by * p.v[0][i];
        for (std::size_t i = 0; i < p.moving(); ++i) {
            p.q[0][i] = start_.q[0][i] + by * p.dv_dt[0][i];
            p.E[i] = start_.E[i] + by * p.dE_dt[i];
        }
    };
    move(dt / 2);
    bool good = true;
    for (std::size_t i = 0; good && i < p.size(); ++i) good = std::isfinite(p.x[0][i]);
    if (good) {
        find_density(t);
        good = recover_all() == p.size();
    }
    if (good) {
        sum_rates();
        good = dt * largest_rate() <= 2 * courant;
    }
    if (good) {
        move(dt);
        good = recover_all() == p.size();
    }
    if (!good) {
        std::swap(p, start_);
        return false;
    }
    for (std::size_t i = p.moving(); i < p.size(); ++i) {
        given_q_ += dt * p.m[i] * p.dv_dt[0][i];
        given_E_ += dt * p.m[i] * p.dE_dt[i];
    }
    return true;
}

template <class K, class S>
template <class AfterStep>
void RelativisticGas<K, S>::advance(double& t, double end, double courant, AfterStep&& after_step) {
    if (!started_) {
        resolve(t);
        sum_rates();
        started_ = true;
    }
    while (t < end) {
        double dt = std::min(courant / largest_rate(), 2 * last_dt_);
        const double left = end - t;
        if (left < 2 * dt) dt = left > dt ? left / 2 : left;
        for (int retry = 0;; ++retry) {
            require_time_step(t, dt);
            if (step(t, dt, courant)) break;
            if (retry == most_retries)
                throw Unstable{t, Unstable::no_particle, "the time step after 20 halvings", dt};
            dt /= 2;
        }
        last_dt_ = dt;
        t = left == dt ? end : t + dt;
        ++neighbours_.counters().steps;
        after_step(t);
    }
    resolve(t);
}

}  // namespace sph
