#include <algorithm>

#include "chapters/03_euler_sph/scenes/star_energy.hpp"
#include "common/plot/looks.hpp"

/// What the first thing that one writes down does: a star alone in space that walks away.
namespace sph::euler {
namespace {

double farthest(const Column& centre) {
    double most = 0;
    for (const double x : centre) most = std::max(most, std::abs(x));
    return most;
}

}  // namespace

void walk(report::Run& run) {
    plot::Figure figure{"walk"};
    plot::Panel& panel = figure.panel().labels("Ω$t$", "centre of mass / radius");
    StarScene scene;
    scene.n = 100;
    scene.spacing = Spacing::masses;
    const CentreRun centres = run_centres(scene, 0.2, run.quick() ? 20 : 200);
    panel.curve(centres.t, centres.centre, {.label = "force (3.2)", .colour = plot::cycle(1)});
    panel.curve(centres.conserving_t, centres.conserving_centre,
                {.label = "force (3.23)", .colour = plot::cycle(0)});
    const double naive = farthest(centres.centre), cured = farthest(centres.conserving_centre);
    run.record("non-conserving", 100, {{"momentum_drift", centres.momentum}, {"farthest_centre", naive}});
    run.record("consistent-h", 100,
               {{"momentum_drift", centres.conserving_momentum}, {"farthest_centre", cured}});
    run.fill("walk", report::number(naive, 1));
    run.fill("walk-cured", cured < 1e-12 ? "10⁻¹²" : report::number(cured, 1));
    run.claim("star-walks", [&] { return naive > 0.1 && cured < 1e-12; });
    run.save(figure);
}

}  // namespace sph::euler
