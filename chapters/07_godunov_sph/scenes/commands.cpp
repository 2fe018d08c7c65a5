#include "chapters/07_godunov_sph/scenes/commands.hpp"

#include <cmath>
#include <numbers>

#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "common/plot/looks.hpp"

namespace sph::godunov {

shocks::TubeKind tube_kind() {
    return {line_methods(), {}, {1, 10, true}, shocks::gas_tube};
}

WaveOfSound::WaveOfSound() : method_{line_methods(), {}, {0.9, 2}} {}

void WaveOfSound::declare(app::CommandLine& line) {
    line.integer("particles", particles_, 8, 4096, "in the box of length 1")
        .number("courant", courant_, {0.001, 0.6}, "", "step over the shortest time between neighbours");
    method_.declare(line);
}

void WaveOfSound::run(report::Run& run) const {
    if (method_.wants_list()) return run.print(line_methods().text());
    const Method<1> method = method_.chosen();
    report::tell(run, method);
    shocks::StandingWave scene{
        .n = static_cast<std::size_t>(particles_), .courant = courant_, .threads = run.threads()};
    Column x, v;
    scene.watch = [&](const Simulation<1>& gas) { x = gas.get<Position>()[0], v = gas.get<Velocity>()[0]; };
    const shocks::StandingWaveRun wave = run_standing_wave(scene, method);
    Column exact(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        exact[i] = scene.amplitude * std::sin(2 * std::numbers::pi * x[i]);
    run.record(method.name, scene.n,
               {{"l1_v", wave.error},
                {"energy_left", wave.energy_left},
                {"steps", static_cast<double>(wave.counters.steps)},
                {"pairs", static_cast<double>(wave.counters.pairs)},
                {"cpu_seconds", wave.seconds, "s"}});
    run.write("profile.csv", report::csv({{"x", x}, {"v", v}, {"exact_v", exact}}));
    plot::Figure figure{"wave", 1, 1};
    plot::beside_exact(figure.at(0, 0).labels("$x$", "$v$"), x, exact, x, v);
    run.save(figure);
}

}  // namespace sph::godunov
