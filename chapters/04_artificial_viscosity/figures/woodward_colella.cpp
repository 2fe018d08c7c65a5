#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "common/exact/woodward_colella.hpp"

namespace sph::shocks {

void woodward_colella(report::Run& run) {
    BlastWaves scene;
    scene.n = run.quick() ? 100 : 400;
    scene.threads = run.threads();
    const auto n = static_cast<long>(scene.n);
    plot::Figure figure{"woodward-colella", 1, 2};
    plot::Panel& rho = figure.at(0, 0).labels("$x$", "ρ").x_range(0.5, 0.9);
    plot::Panel& v = figure.at(0, 1).labels("$x$", "$v$").x_range(0.5, 0.9);
    Column x, density, velocity;
    for (const auto& node : exact::WoodwardColella{}.nodes()) {
        x.push_back(node.x);
        density.push_back(node.rho);
        velocity.push_back(node.v);
    }
    plot::Style reference = exact_line();
    reference.label = "reference";
    rho.curve(x, density, reference);
    v.curve(x, velocity, reference);
    report::Table table{{"method", "ρ %", "v %", "P %", "energy drift", "steps", "CPU ms"}};
    const auto row = [&](const std::string& name, const std::string& label, const TubeRun& tube) {
        run.result(name, n, "l1_rho", tube.l1_rho);
        run.result(name, n, "l1_v", tube.l1_v);
        run.result(name, n, "l1_p", tube.l1_p);
        run.result(name, n, "cpu_seconds", tube.seconds, "s");
        table.row({label, report::number(100 * tube.l1_rho, 2), report::number(100 * tube.l1_v, 2),
                   report::number(100 * tube.l1_p, 2),
                   tube.energy_drift < 1e-12 ? "rounding" : report::number(tube.energy_drift, 1),
                   std::to_string(tube.counters.steps), report::timing(1e3 * tube.seconds)});
    };
    for (const std::string name : {"signal", "price", "narrow", "reconstructed"}) {
        const Method& method = tube_method(name);
        const TubeRun tube = run_blast_waves(scene, method);
        run.result(name, n, "energy_drift", tube.energy_drift);
        row(name, method.label, tube);
        if (name != "narrow" && name != "reconstructed") continue;
        rho.points(tube.profile.x, tube.profile.rho, dots(style_of(name)));
        v.points(tube.profile.x, tube.profile.v, dots(style_of(name)));
    }
    row("grid", "grid, Eulerian", run_grid_blast_waves(scene, exact::Frame::eulerian));
    row("grid-lagrangian", "grid, Lagrangian", run_grid_blast_waves(scene, exact::Frame::lagrangian));
    rho.legend.shown = false;
    v.legend.outside = true;
    run.save(figure);
    run.fill("woodward-colella", table.markdown());
}

}  // namespace sph::shocks
