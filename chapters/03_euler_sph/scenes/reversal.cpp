#include "chapters/03_euler_sph/scenes/reversal.hpp"

#include "chapters/03_euler_sph/fixed_point.hpp"

namespace sph::euler {
namespace {

/// dt, shortened in proportion to the speed of sound where that is largest.
double sound_limit(const LineGas& gas, const WaveScene& scene, double dt) {
    double fastest = 0;
    for (const double rho : gas.get<Density>()) fastest = std::max(fastest, scene.state().sound_speed(rho));
    return dt / fastest;
}

/// Lets the gas step by the integrator of that name; returns what reverses the motion.
std::function<void()> integrate_by_name(LineGas& gas, const std::string& name, double dt,
                                        const std::function<double()>& limit) {
    Column& v = gas.get<Velocity>()[0];
    const std::function<void()> turn = [&v] {
        for (double& one : v) one = -one;
    };
    gas.limit_steps([dt] { return dt; });
    if (name == "kick-drift-kick") return gas.integrate_by<KickDriftKick>(), turn;
    if (name == "drift-kick-drift") return gas.integrate_by<DriftKickDrift>(), turn;
    if (name == "RK4") return gas.integrate_by<RungeKutta4>(), turn;
    if (name == "fixed point") {
        auto& leapfrog = gas.integrate_by<FixedPointLeapfrog<1>>(gas.get<Position>(), gas.get<Velocity>(),
                                                                 gas.get<Acceleration>());
        leapfrog.restart();  // so that the start is what can come back
        return [&leapfrog] { leapfrog.reverse(); };
    }
    if (name == "reversible steps") {
        gas.rates(0);
        gas.integrate_by<ReversibleSteps>(limit, limit());
        return gas.limit_steps({}), turn;
    }
    if (name == "naive steps")  // the limit at the beginning of the step, as most codes do
        return gas.integrate_by<KickDriftKick>(), gas.limit_steps(limit), turn;
    throw std::invalid_argument{"no such integrator: " + name};
}

}  // namespace

ReversalRun run_reversal(const std::string& name, int waves, int steps, std::size_t n) {
    WaveScene scene;
    scene.n = n;
    scene.amplitude = 0.05;
    scene.waves = waves;
    const double dt = 13.7 / 4000 * 100 / static_cast<double>(n);
    const auto gas = wave_gas(scene, {"fixed-h", "cubic", 1.3});
    const auto turn = integrate_by_name(*gas, name, dt, [&] { return sound_limit(*gas, scene, dt); });
    gas->rates(0);
    const Column x = gas->get<Position>()[0], v = gas->get<Velocity>()[0];
    Drifts drifts{*gas};
    ReversalRun run;
    double t = 0;
    int k = 0;
    const auto watch = [&](double now) {
        if (k++ % 10 != 0) return;
        gas->resolve(now);
        drifts.look();
    };
    // [loop]
    march(*gas, t, {.steps = steps}, watch);
    run.time = t;
    turn();  // all velocities change sign
    march(*gas, t, {.steps = steps}, watch);
    // [end]
    run.energy_drift = drifts.energy() / (square(scene.amplitude) / 4);
    run.bitwise = gas->get<Position>()[0] == x;
    for (std::size_t i = 0; i < n; ++i) {
        const auto count = static_cast<double>(n);
        run.velocity_error += square((gas->get<Velocity>()[0][i] + v[i]) / scene.amplitude) * 2 / count;
        run.position_error += square((gas->get<Position>()[0][i] - x[i]) * count) / count;
    }
    run.velocity_error = std::sqrt(run.velocity_error);
    run.position_error = std::sqrt(run.position_error);
    run.x = gas->get<Position>()[0];
    run.v = gas->get<Velocity>()[0];
    run.start_v = v;
    return run;
}

}  // namespace sph::euler
