#include <algorithm>
#include <cmath>

#include "chapters/05_tensile_instability/figures/cures.hpp"

namespace sph::tensile {

/// What order costs: the shortfall of the smallest distance against the CPU time of the run.
void cure_cost(report::Run& run) {
    CureScene scene = cure_scene(run);
    plot::Figure figure{"cure-cost"};
    figure.panel_width = 560, figure.panel_height = 340;
    plot::Panel& panel =
        figure.panel().labels("CPU time of a rate, a particle [ns]", "smallest distance at the end [dx]");
    std::map<std::string, double> price;
    bool left = false;
    for (const CureMethod& method : cure_methods()) {
        CureRun best = run_cure(scene, method);
        const CureRun again = run_cure(scene, method);
        best.seconds = std::min(best.seconds, again.seconds);
        run.record(method.name, scene.n, best.measured());
        price[method.name] = 1e9 * best.seconds /
                             (static_cast<double>(best.evaluations) * static_cast<double>(best.x[0].size()));
        panel.points({price[method.name]}, {best.smallest_distance},
                     {.colour = plot::cycle(0), .marker = plot::Marker::circle});
        plot::Note& note = panel.note(price[method.name] + (left ? -6 : 6), best.smallest_distance,
                                      method.label);
        note.anchor = left ? plot::Anchor::right : plot::Anchor::left;
        note.size = 7, left = !left;
    }
    panel.y_range(-0.03, 1.08);
    run.save(figure);
    run.claim("balanced-costs", [&] {
        return price["balanced"] < 6 * price["none"] && price["balanced"] > 1.5 * price["background"];
    });
}

}  // namespace sph::tensile
