#include "chapters/03_euler_sph/scenes/reversal.hpp"

#include "chapters/03_euler_sph/fixed_point.hpp"

namespace sph {
namespace {

using OscillationGas = WaveGas<FixedH<CubicSpline<1>>>;
using Motion = OscillationGas::Motion;

void reverse(OscillationGas& gas) {
    for (double& v : gas.particles.v[0]) v = -v;
}

/// Runs `steps` steps, reverses, runs them again. `step` makes one; `turn` is called at the reversal.
template <class Step, class Turn>
ReversalRun there_and_back(OscillationGas& gas, double amplitude, int steps, Step&& step, Turn&& turn) {
    auto& p = gas.particles;
    gas.rates(0);
    const Column x = p.x[0], v = p.v[0];
    const double start = gas.energy(), scale = square(amplitude) / 4;
    ReversalRun run;
    double t = 0;
    for (int k = 0; k < 2 * steps; ++k) {
        if (k == steps) {
            run.time = t;
            turn();
        }
        step(t);
        if (k % 10 != 0) continue;
        gas.resolve(t);
        run.energy_drift = std::max(run.energy_drift, std::abs(gas.energy() - start) / scale);
    }
    run.bitwise = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto n = static_cast<double>(x.size());
        run.velocity_error += square((p.v[0][i] + v[i]) / amplitude) * 2 / n;
        run.position_error += square((p.x[0][i] - x[i]) * n) / n;
        run.bitwise = run.bitwise && p.x[0][i] == x[i];
    }
    run.velocity_error = std::sqrt(run.velocity_error);
    run.position_error = std::sqrt(run.position_error);
    run.x = p.x[0];
    run.v = p.v[0];
    run.start_v = v;
    return run;
}

/// With an integrator of the engine and a constant step.
template <class Integrator>
ReversalRun constant_steps(OscillationGas& gas, double amplitude, int steps, double dt) {
    Integrator integrator{gas.counters()};
    if constexpr (requires { integrator.start(gas.particles); }) integrator.start(gas.particles);
    return there_and_back(
        gas, amplitude, steps,
        [&](double& t) { integrator.step(gas.particles, t, dt, [&](double now) { gas.rates(now); }); },
        [&] {
            if constexpr (requires { integrator.reverse(); }) {
                integrator.reverse();
            } else {
                reverse(gas);
            }
        });
}

}  // namespace

ReversalRun run_reversal(const std::string& name, int waves, int steps, std::size_t n) {
    WaveScene scene;
    scene.n = n;
    scene.amplitude = 0.05;
    scene.waves = waves;
    const double h = 1.3 * scene.spacing(), dt = 13.7 / 4000 * 100 / static_cast<double>(n),
                 a = scene.amplitude;
    OscillationGas gas = wave_gas(scene, FixedH<CubicSpline<1>>{h});
    auto& p = gas.particles;
    const auto rates = [&](double t) { gas.rates(t); };
    const auto limit = [&] { return gas.time_step(dt / h, [h](std::size_t) { return h; }); };
    const auto turn = [&] { reverse(gas); };
    if (name == "kick-drift-kick") return constant_steps<KickDriftKick<Motion>>(gas, a, steps, dt);
    if (name == "drift-kick-drift") return constant_steps<DriftKickDrift<Motion>>(gas, a, steps, dt);
    if (name == "fixed point") return constant_steps<FixedPointLeapfrog>(gas, a, steps, dt);
    if (name == "RK4") return constant_steps<RungeKutta4<Motion>>(gas, a, steps, dt);
    if (name == "reversible steps") {
        ReversibleSteps<Motion> integrator{gas.counters()};
        gas.rates(0);
        double step = limit();
        return there_and_back(
            gas, a, steps, [&](double& t) { integrator.step(p, t, step, rates, limit); }, turn);
    }
    if (name == "naive steps") {  // the limit at the beginning of the step, as most codes do
        KickDriftKick<Motion> integrator{gas.counters()};
        return there_and_back(
            gas, a, steps, [&](double& t) { integrator.step(p, t, limit(), rates); }, turn);
    }
    throw std::invalid_argument{"no such integrator: " + name};
}

}  // namespace sph
