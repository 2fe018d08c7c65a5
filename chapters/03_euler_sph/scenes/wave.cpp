#include "chapters/03_euler_sph/scenes/wave.hpp"

#include "chapters/03_euler_sph/dispersion.hpp"
#include "common/plot/looks.hpp"

namespace sph::euler {
namespace {

double velocity_error(const LineGas& gas, const WaveScene& scene, double t) {
    const Column &x = gas.get<Position>()[0], &v = gas.get<Velocity>()[0];
    double error = 0, size = 0;
    for (std::size_t i = 0; i < scene.n; ++i) {
        error += std::abs(v[i] - scene.velocity(x[i], t));
        size += std::abs(scene.velocity(x[i], 0));
    }
    return error / size;
}

/// The part of the velocity that is the wave.
double projection(const LineGas& gas, const WaveScene& scene) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * scene.spacing();
        sum += gas.get<Velocity>()[0][i] * std::sin(scene.k() * x);
    }
    return sum;
}

}  // namespace

std::unique_ptr<LineGas> wave_gas(const WaveScene& scene, const GasMethod& method) {
    auto gas = with_resolution(method, scene.spacing(), [&](const auto& resolution) {
        return line_gas(scene.n, resolution, Barotropic<Polytrope>{scene.state()}, periodic_unit_box<1>(),
                        scene.threads);
    });
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * scene.spacing();
        gas->get<Position>()[0][i] = x;
        gas->get<Velocity>()[0][i] = scene.velocity(x, 0);
        gas->get<Mass>()[i] = scene.spacing();
        gas->get<Density>()[i] = 1;
    }
    gas->start(0);
    return gas;
}

WaveRun run_wave(const WaveScene& scene, const GasMethod& method) {
    const auto gas = wave_gas(scene, method);
    gas->integrate_by<RungeKutta4>();
    gas->resolve(0);
    Drifts drifts{*gas};
    const double energy = square(scene.amplitude) / 4, end = scene.periods / scene.waves;
    WaveRun run;
    double t = 0;
    const StepControl control{.end = end,
                              .steps = std::lround(std::ceil(end / (scene.courant * scene.spacing()))),
                              .progress = scene.progress};
    run.seconds = march(*gas, t, control, [&](double now) {
                      gas->resolve(now);
                      run.t.push_back(now);
                      run.error_at.push_back(velocity_error(*gas, scene, now));
                      run.error = std::max(run.error, run.error_at.back());
                      drifts.look();
                  }).seconds;
    run.energy_drift = drifts.energy() / energy;
    run.momentum_drift = drifts.momentum() / scene.amplitude;
    run.x = gas->get<Position>()[0];
    run.v = gas->get<Velocity>()[0];
    for (const double x : run.x) run.exact.push_back(scene.velocity(x, t));
    run.counters = gas->counters();
    return run;
}

report::Quantities WaveRun::measured() const {
    return {{"l1_v", error},
            {"momentum_drift", momentum_drift},
            {"pairs", static_cast<double>(counters.pairs)},
            {"steps", static_cast<double>(counters.steps)}};
}

/// With leapfrog the projection is cos(step a), sin(a/2) = omega dt/2. The first zero after the given number
/// of periods is found by linear interpolation of the phase between two steps.
double measured_omega2(const WaveScene& given, const GasMethod& given_method, int periods) {
    WaveScene scene = given;
    GasMethod method = given_method;
    with_kernel<1>(method.kernel, [&](const auto& kernel) {
        scene.density = lattice_density<std::decay_t<decltype(kernel)>>(method.h_over_dx);
    });
    if (method.resolution != "fixed-h") method.h_over_dx *= scene.density;  // h = h_over_dx m/rho
    const auto gas = wave_gas(scene, method);
    const double dt = scene.courant * scene.spacing(), start = projection(*gas, scene);
    gas->limit_steps([dt] { return dt; });
    double t = 0, before = 1, omega2 = 0;
    int zeros = 0;
    long step = 0;
    march(*gas, t, {.end = std::numeric_limits<double>::max()}, [&](double) {
        ++step;
        const double now = projection(*gas, scene) / start;
        zeros += (before > 0) != (now > 0) ? 1 : 0;
        before = now;
        if (zeros < 2 * periods) return true;
        // now = cos(step a) and the phase step a lies just beyond (2 periods - 1/2) pi.
        const double phase = (2 * periods - 0.5) * std::numbers::pi + std::asin(now);
        omega2 = square(2 / dt * std::sin(phase / static_cast<double>(step) / 2));
        return false;
    });
    return omega2;
}

void WaveCommand::declare(app::CommandLine& line) {
    choice_.declare(line, resolution_names());
    line.number("gamma", gamma_, {1, 100, true}, "", "adiabatic index")
        .integer("particles", particles_, 8, 4096, "of the wave");
}

void WaveCommand::run(report::Run& run) const {
    WaveScene scene;
    scene.n = static_cast<std::size_t>(particles_);
    scene.gamma = gamma_;
    scene.threads = run.threads();
    scene.progress = run.progress();
    const GasMethod& method = choice_.chosen();
    const WaveRun wave = run_wave(scene, method);
    run.record(method.resolution, scene.n, wave.measured());
    run.write("profile.csv", report::csv({{"x", wave.x}, {"v", wave.v}, {"exact_v", wave.exact}}));
    plot::Figure figure{"wave"};
    plot::beside_exact(figure.panel().labels("$x$", "$v$"), wave.x, wave.exact, wave.x, wave.v, 4);
    run.save(figure);
}

}  // namespace sph::euler
