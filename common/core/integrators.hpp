#pragma once
#include "common/core/counters.hpp"
#include "common/core/equations.hpp"

/// Time integration. Every integrator has
///     step(particles, t, dt, rates)
/// which advances what the equations `Motion` evolve, and t, by dt (which may be negative: back in time).
/// rates(t) is the scene's: it fills the columns of rates from the particles' present state. An integrator
/// counts its steps, allocates nothing after the first, and throws Unstable when the new state has lost its
/// meaning, or when dt no longer moves t on.
namespace sph {

namespace integrators_detail {

template <class Motion, class P>
void finish_step(const P& particles, double t, Counters& counters) {
    ++counters.steps;
    Motion::require_physical(particles, t);
}

}  // namespace integrators_detail

/// Leapfrog, kick-drift-kick (Monaghan 2005, 5.51-5.53). Second order; symplectic and reversible where rates
/// depend on positions only. One evaluation of the rates a step: those of the end serve the next beginning,
/// unless restart() says that the state was changed in between.
template <class Motion>
class KickDriftKick {
  public:
    explicit KickDriftKick(Counters& counters) : counters_{&counters} {}
    void restart() { has_rates_ = false; }
    template <class P, class Rates>
    void step(P& particles, double& t, double dt, Rates&& rates) {
        require_time_step(t, dt);
        if (!has_rates_) rates(t);
        Motion::kick(particles, dt / 2);
        Motion::drift(particles, dt);
        t += dt;
        rates(t);
        has_rates_ = true;
        Motion::kick(particles, dt / 2);
        integrators_detail::finish_step<Motion>(particles, t, *counters_);
    }

  private:
    Counters* counters_;
    bool has_rates_ = false;
};

/// Leapfrog, drift-kick-drift: Monaghan's Verlet (5.42-5.44). Second order; symplectic and reversible where
/// rates depend on positions only. One evaluation a step.
template <class Motion>
class DriftKickDrift {
  public:
    explicit DriftKickDrift(Counters& counters) : counters_{&counters} {}
    template <class P, class Rates>
    void step(P& particles, double& t, double dt, Rates&& rates) {
        require_time_step(t, dt);
        Motion::drift(particles, dt / 2);
        rates(t + dt / 2);
        Motion::kick(particles, dt);
        Motion::drift(particles, dt / 2);
        t += dt;
        integrators_detail::finish_step<Motion>(particles, t, *counters_);
    }

  private:
    Counters* counters_;
};

/// How the two halves of a reversible step share the limit found in the middle.
enum class HalfSteps {
    arithmetic,  ///< dt_half = (dt_0 + dt_1) / 2     (Monaghan 2005, 5.49)
    harmonic     ///< 2 / dt_half = 1 / dt_0 + 1 / dt_1   (5.50)
};

/// Drift-kick-drift with a step that varies and can still be run backwards (5.45-5.48, with the factor 1/2
/// that 5.47 lacks as printed): the limit is taken in the middle, from positions, and symmetric in both
/// halves.
template <class Motion>
class ReversibleSteps {
  public:
    explicit ReversibleSteps(Counters& counters, HalfSteps rule = HalfSteps::harmonic)
        : counters_{&counters}, rule_{rule} {}
    /// Advances t by (dt_0 + dt_1) / 2, where dt enters as dt_0 and leaves as dt_1. limit() is the step that
    /// the positions allow, called after rates(t) in the middle. To go back, reverse the velocities and go
    /// on. Throws Unstable if the limit changes so fast that dt_1 would not be positive.
    template <class P, class Rates, class Limit>
    void step(P& particles, double& t, double& dt, Rates&& rates, Limit&& limit) {
        require_time_step(t, dt);
        const double dt_0 = dt;
        Motion::drift(particles, dt_0 / 2);
        rates(t + dt_0 / 2);
        Motion::kick(particles, dt_0 / 2);
        const double dt_half = limit();
        const double dt_1 = rule_ == HalfSteps::harmonic ? 1 / (2 / dt_half - 1 / dt_0) : 2 * dt_half - dt_0;
        if (!(dt_1 > 0)) throw Unstable{t, Unstable::no_particle, "the time step", dt_1};
        Motion::kick(particles, dt_1 / 2);
        Motion::drift(particles, dt_1 / 2);
        t += (dt_0 + dt_1) / 2;
        dt = dt_1;
        integrators_detail::finish_step<Motion>(particles, t, *counters_);
    }

  private:
    Counters* counters_;
    HalfSteps rule_;
};

/// Predictor-corrector with one evaluation a step: everything is predicted to the middle with the rates of
/// the last middle, and advanced over the whole step with those found there. Second order for rates that
/// depend on anything (velocities, thermal energy).
template <class Motion>
class PredictorCorrector {
  public:
    explicit PredictorCorrector(Counters& counters) : counters_{&counters} {}
    void restart() { has_rates_ = false; }
    template <class P, class Rates>
    void step(P& particles, double& t, double dt, Rates&& rates) {
        require_time_step(t, dt);
        if (!has_rates_) rates(t);
        start_.save(particles);
        start_.advance(particles, dt / 2);
        rates(t + dt / 2);
        has_rates_ = true;
        start_.advance(particles, dt);
        t += dt;
        integrators_detail::finish_step<Motion>(particles, t, *counters_);
    }

  private:
    Counters* counters_;
    Saved<Motion> start_;
    bool has_rates_ = false;
};

/// Runge-Kutta of second order (midpoint rule), two evaluations a step.
template <class Motion>
class RungeKutta2 {
  public:
    explicit RungeKutta2(Counters& counters) : counters_{&counters} {}
    template <class P, class Rates>
    void step(P& particles, double& t, double dt, Rates&& rates) {
        require_time_step(t, dt);
        start_.save(particles);
        rates(t);
        start_.advance(particles, dt / 2);
        rates(t + dt / 2);
        start_.advance(particles, dt);
        t += dt;
        integrators_detail::finish_step<Motion>(particles, t, *counters_);
    }

  private:
    Counters* counters_;
    Saved<Motion> start_;
};

/// The classical Runge-Kutta method of fourth order, four evaluations a step.
template <class Motion>
class RungeKutta4 {
  public:
    explicit RungeKutta4(Counters& counters) : counters_{&counters} {}
    template <class P, class Rates>
    void step(P& particles, double& t, double dt, Rates&& rates) {
        require_time_step(t, dt);
        start_.save(particles);
        sum_.save(particles);
        rates(t);
        sum_.add(particles, dt / 6);
        start_.advance(particles, dt / 2);
        rates(t + dt / 2);
        sum_.add(particles, dt / 3);
        start_.advance(particles, dt / 2);
        rates(t + dt / 2);
        sum_.add(particles, dt / 3);
        start_.advance(particles, dt);
        rates(t + dt);
        sum_.advance(particles, dt / 6);
        t += dt;
        integrators_detail::finish_step<Motion>(particles, t, *counters_);
    }

  private:
    Counters* counters_;
    Saved<Motion> start_, sum_;
};

}  // namespace sph
