#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/exact/transverse.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {
namespace {

constexpr double freeze = 0.35;

/// Where the mean temperature of rings, from outside, first rises through T_d; 0 if nowhere.
double surface_of(const Snapshot& shot) {
    constexpr double dr = 0.25, end = 30;
    return shocks::outermost_rise(shocks::ring_means(shot.r, shot.temperature, shot.area, dr, end), freeze);
}

}  // namespace

/// The picture of what the rarefaction has reached, with the surface T = T_d in it.
void freeze_out(report::Run& run) {
    const exact::TransverseFlow solution{10, 1, 1.0 / 3};
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    PlaneScene scene{.n = run.quick() ? 1000UL : 10000UL, .times = {}};
    for (int k = 1; k <= (run.quick() ? 3 : 11); ++k) scene.times.push_back(1 + 2 * k);
    scene.times.insert(scene.times.begin(), {1.001, 2});
    const auto shots = run_plane(flow, scene, plane_methods().recommended());
    plot::Figure figure{"freeze-out", 1, 2};
    plot::Panel& paths = figure.at(0, 0).labels("$r$", "τ").x_range(0, 32).y_range(1, 24);
    for (const double share : {0.02, 0.06, 0.14, 0.25, 0.4, 0.6, 0.8, 0.9, 0.97}) {
        const auto i = static_cast<std::size_t>(share * static_cast<double>(shots.front().r.size()));
        plot::Values r, tau;
        for (const Snapshot& shot : shots) r.push_back(shot.r[i]), tau.push_back(shot.time);
        paths.curve(r, tau, {.colour = plot::Colour{0.6, 0.6, 0.6}, .width = 1});
    }
    paths.curve({10, 0}, {1, solution.axis_time()}, {.label = "head", .colour = plot::cycle(1), .width = 2});
    paths.curve({10, 33}, {1, 24}, {.label = "edge of the vacuum", .colour = plot::cycle(3), .width = 2});
    const auto surface = exact::freeze_out_surface(solution, freeze);
    plot::Values exact_r, exact_tau;
    for (const exact::SurfaceEvent& event : surface)
        exact_r.push_back(event.r), exact_tau.push_back(event.tau);
    paths.curve(exact_r, exact_tau, plot::exact("$T$ = 0.35 $T$_{0}"));
    plot::Values tau, radius, found_tau, error;
    double worst = 0;
    for (const Snapshot& shot : shots) {
        const double r = surface_of(shot);
        if (!(r > 0)) continue;
        found_tau.push_back(shot.time), radius.push_back(r);
        // The outermost place of the exact one at this tau.
        const FlowProfile profile = flow.exact(shot.time);
        double low = 0, high = solution.edge(shot.time);
        if (profile(0).temperature < freeze) continue;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (profile(middle).temperature > freeze ? low : high) = middle;
        }
        tau.push_back(shot.time), error.push_back(r - low);
        if (low > 1) worst = std::max(worst, std::abs(r - low));
    }
    paths.points(
        radius, found_tau,
        plot::dots({.label = "particles", .colour = plot::cycle(0), .marker = plot::Marker::circle}, 4));
    plot::Panel& difference = figure.at(0, 1).labels("τ", "radius of $T$ = 0.35 $T$_{0}, particles – exact");
    difference.curve(tau, error, {.colour = plot::cycle(0), .marker = plot::Marker::circle});
    run.save(figure);
    run.record("spiral-graded", shots.front().x.size(), {{"linf_radius", worst}});
    run.fill("freeze-worst", report::number(worst, 1));
    run.claim("freeze-good", [&] { return worst < 0.1; });
}

}  // namespace sph::transverse
