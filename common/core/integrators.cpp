#include "common/core/integrators.hpp"

#include "common/core/unstable.hpp"

namespace sph {

bool Integrator::step(double& t, double dt) {
    require_time_step(t, dt);
    advance(t, dt);
    motion_->require_physical(t);
    return true;
}

// [leapfrog]
void KickDriftKick::advance(double& t, double dt) {
    if (!has_rates_) rates(t);
    motion().kick(dt / 2);
    motion().drift(dt);
    t += dt;
    rates(t);
    has_rates_ = true;
    motion().kick(dt / 2);
}
// [end]

void DriftKickDrift::advance(double& t, double dt) {
    motion().drift(dt / 2);
    rates(t + dt / 2);
    motion().kick(dt);
    motion().drift(dt / 2);
    t += dt;
}

void PredictorCorrector::advance(double& t, double dt) {
    if (!has_rates_) rates(t);
    start_.save(motion());
    start_.advance(motion(), dt / 2);
    rates(t + dt / 2);
    has_rates_ = true;
    start_.advance(motion(), dt);
    t += dt;
}

void RungeKutta2::advance(double& t, double dt) {
    start_.save(motion());
    rates(t);
    start_.advance(motion(), dt / 2);
    rates(t + dt / 2);
    start_.advance(motion(), dt);
    t += dt;
}

void RungeKutta4::advance(double& t, double dt) {
    start_.save(motion());
    sum_.save(motion());
    rates(t);
    sum_.add(motion(), dt / 6);
    start_.advance(motion(), dt / 2);
    rates(t + dt / 2);
    sum_.add(motion(), dt / 3);
    start_.advance(motion(), dt / 2);
    rates(t + dt / 2);
    sum_.add(motion(), dt / 3);
    start_.advance(motion(), dt);
    rates(t + dt);
    sum_.advance(motion(), dt / 6);
    t += dt;
}

// [reversible]
void ReversibleSteps::advance(double& t, double dt_0) {
    motion().drift(dt_0 / 2);
    rates(t + dt_0 / 2);
    motion().kick(dt_0 / 2);
    const double dt_half = limit_();
    const double dt_1 = rule_ == HalfSteps::harmonic ? 1 / (2 / dt_half - 1 / dt_0) : 2 * dt_half - dt_0;
    if (!(dt_1 > 0)) throw Unstable{t, Unstable::no_particle, "the time step", dt_1};
    motion().kick(dt_1 / 2);
    motion().drift(dt_1 / 2);
    t += (dt_0 + dt_1) / 2;
    dt_ = dt_1;
}
// [end]

}  // namespace sph
