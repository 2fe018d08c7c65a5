#include "chapters/09_transverse_expansion/scenes/plateau.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"

namespace sph::transverse {

/// Three dimensions, seen at eta = 0.
void plateau(report::Run& run) {
    const PlateauScene scene{.per_layer = run.quick() ? 60UL : 800UL, .time = run.quick() ? 2.0 : 4.0};
    const PlateauRun space = run_plateau(scene);
    const FlowProfile exact = cylinder(10, 1, 1.0 / 3).exact(scene.time);
    plot::Figure figure{"plateau", 1, 2};
    plot::Panel& T = figure.at(0, 0).labels("$r$", "$T$/$T$_{0}").x_range(0, 10 + scene.time);
    T.points(space.r, space.temperature,
             plot::dots({.label = "3D, η = 0", .colour = plot::cycle(0), .marker = plot::Marker::circle}, 4));
    T.points(space.plane_r, space.plane_temperature,
             plot::dots({.label = "2D", .colour = plot::cycle(1), .marker = plot::Marker::cross}, 4));
    plot::draw_exact(T, 0, (9 + scene.time) * 0.999, [&](double r) { return exact(r).temperature; });
    plot::Panel& rings =
        figure.at(0, 1).labels("$r$", "mean of a ring over that in 2D – 1, %").x_range(0, 10).y_range(-3, 3);
    plot::Values by;
    for (std::size_t k = 0; k < space.rings.size() && k < space.plane_rings.size(); ++k)
        by.push_back(100 * (space.rings[k] / space.plane_rings[k] - 1));
    rings.curve({space.rings_r.begin(), space.rings_r.begin() + static_cast<std::ptrdiff_t>(by.size())}, by,
                {.colour = plot::cycle(0), .marker = plot::Marker::circle});
    run.save(figure);
    double fastest = 0;
    for (const double v : space.eta_velocity) fastest = std::max(fastest, std::abs(v) * scene.time);
    run.record("3d", space.n,
               {{"difference", space.difference},
                {"l1_temperature", space.l1_temperature},
                {"plane_l1_temperature", space.plane_l1_temperature},
                {"tau_v_eta", fastest},
                {"steps", static_cast<double>(space.counters.steps)}});
    run.fill("plateau-n", std::to_string(space.n));
    run.fill("plateau-difference", report::percent(space.difference));
    run.fill("plateau-l1", report::percent(space.l1_temperature));
    run.fill("plateau-plane-l1", report::percent(space.plane_l1_temperature));
    run.claim("plateau-agrees", [&] { return space.difference < 0.01; });
}

}  // namespace sph::transverse
