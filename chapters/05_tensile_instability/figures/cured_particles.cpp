#include "chapters/05_tensile_instability/figures/cures.hpp"

namespace sph::tensile {

/// Where the particles of four methods are at the end.
void cured_particles(report::Run& run) {
    const CureScene scene = cure_scene(run);
    plot::Figure figure{"cured-particles", 1, 4};
    figure.panel_width = 230, figure.panel_height = 260;
    int column = 0;
    std::map<std::string, double> order;
    for (const CureMethod& method : cure_methods().named({"none", "stress-xsph", "corrected", "balanced"})) {
        const CureRun cured = run_cure(scene, method);
        run.record(method.name, scene.n, cured.measured());
        order[method.name] = cured.order;
        plot::Panel& panel = figure.at(0, column++).titled(method.label).labels("$x$ / dx", "$y$ / dx");
        panel.equal_aspect = true;
        panel.points(cured.x[0], cured.x[1],
                     {.colour = plot::cycle(0), .marker = plot::Marker::circle, .marker_size = 3});
    }
    run.save(figure);
    run.claim(
        "cured-in-order",
        [&] { return order["balanced"] > 0.95 && order["none"] < 0.6 && order["stress-xsph"] < 0.6; },
        report::Needs::any_run);
}

}  // namespace sph::tensile
