#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"

#include <cmath>
#include <numbers>

namespace sph::shocks {

StandingWaveRun run_standing_wave(const StandingWave& scene, const Method<1>& method) {
    constexpr double gamma = 1.4;
    const double dx = 1.0 / static_cast<double>(scene.n), k = 2 * std::numbers::pi;
    const auto gas = method.make({.n = scene.n,
                                  .state = IdealGas{gamma},
                                  .box = Box<1>{{0}, {1}, Face::periodic},
                                  .courant = scene.courant,
                                  .threads = scene.threads});
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * dx;
        gas->place(i, {x}, {scene.amplitude * std::sin(k * x)}, dx, 1, 1 / gamma);  // c_s = 1
    }
    gas->start(0);
    StandingWaveRun run;
    double t = 0;
    run.seconds = march(*gas, t, {.end = 1}, [&](double now) {
                      double error = 0, size = 0, motion = 0;
                      for (std::size_t i = 0; i < scene.n; ++i) {
                          const double x = gas->get<Position>()[0][i], v = gas->get<Velocity>()[0][i];
                          error += std::abs(v - scene.amplitude * std::cos(k * now) * std::sin(k * x));
                          size += std::abs(scene.amplitude * std::sin(k * x));
                          motion += 2 * dx * v * v / (scene.amplitude * scene.amplitude);
                      }
                      run.error = std::max(run.error, error / size);
                      run.energy_left = motion;  // sum m v^2 / (amplitude^2/2)
                      if (scene.watch) scene.watch(*gas);
                  }).seconds;
    run.counters = gas->counters();
    return run;
}

}  // namespace sph::shocks
