#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"

#include <cmath>
#include <numbers>

#include "common/report/timer.hpp"

namespace sph {

StandingWaveRun run_standing_wave(const StandingWave& scene, const Method& method) {
    constexpr double gamma = 1.4, u = 1 / (gamma * (gamma - 1));  // c_s = 1
    const double dx = 1.0 / static_cast<double>(scene.n), k = 2 * std::numbers::pi;
    const auto gas = make_model(method, scene.n, gamma, Box<1>{{0}, {1}, Face::periodic}, scene.threads);
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * dx;
        gas->set(i, {x}, {scene.amplitude * std::sin(k * x)}, dx, 1, u);
    }
    StandingWaveRun run;
    double motion = 0;  // sum m v^2 / (amplitude^2/2)
    const auto compare = [&](double t) {
        double error = 0, size = 0;
        motion = 0;
        for (std::size_t i = 0; i < scene.n; ++i) {
            const double x = gas->x()[0][i], v = gas->v()[0][i];
            error += std::abs(v - scene.amplitude * std::cos(k * t) * std::sin(k * x));
            size += std::abs(scene.amplitude * std::sin(k * x));
            motion += 2 * dx * v * v / (scene.amplitude * scene.amplitude);
        }
        run.error = std::max(run.error, error / size);
    };
    const double begin = report::thread_cpu_seconds();
    double t = 0;
    gas->advance(t, 1, scene.courant, compare);
    run.seconds = report::thread_cpu_seconds() - begin;
    run.energy_left = motion;
    run.counters = gas->counters();
    return run;
}

}  // namespace sph
