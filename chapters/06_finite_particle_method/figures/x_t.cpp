#include <cmath>

#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/plot/looks.hpp"

/// The world lines of the fluid, and how close they come.
namespace sph::fpm {
namespace {

Column times() {
    Column t;
    for (int k = 0; k <= 50; ++k) t.push_back(0.02 * k);
    return t;
}

}  // namespace

void x_t(report::Run& run) {
    const Column t = times();
    plot::Figure figure{"x-t", 1, 2};
    plot::Panel& lines = figure.at(0, 0).titled("world lines, γ = 0.02").labels("$x$", "$t$");
    constexpr int count = 24;
    for (int k = 0; k < count; ++k) {
        const double X = (k + 0.5) / count;
        lines.curve(exact_path(0.02, X, t), t,
                    {.colour = plot::cycle(0), .width = 1.2, .marker = plot::Marker::none});
    }
    lines.x_range(0, 1).y_range(0, 1);
    plot::Panel& gaps = figure.at(0, 1)
                            .log_y()
                            .titled("distance of neighbours at $x$ = 1")
                            .labels("$t$", "in first spacings");
    double last = 1;
    for (const double viscosity : {0.1, 0.02, 0.005}) {
        constexpr double near = 1e-7;  // of the wall: so near, the distance is that of the flow at it
        Column gap = exact_path(viscosity, 1 - near, t);
        for (double& x : gap) x = std::max(1 - x, 1e-16) / near;
        // Below 1e-8 nothing is left of 1 - x but rounding.
        std::size_t shown = 0;
        while (shown < gap.size() && gap[shown] > 1e-7) ++shown;
        gap.resize(shown);
        gaps.curve({t.begin(), t.begin() + static_cast<long>(shown)}, gap,
                   {.label = "γ = " + written(viscosity)});
        if (viscosity == 0.02) last = gap[std::min<std::size_t>(25, shown - 1)];
    }
    run.record("exact", 0, {{"gap_at_half", last}});
    run.fill("gap-at-half", report::number(last, 1));
    run.claim(
        "gap-vanishes", [&] { return last < 0.01 && last > 1e-6; }, report::Needs::any_run);
    run.save(figure);
}

}  // namespace sph::fpm
