#include "chapters/01_kernel_interpolation/scenes/listed_estimates.hpp"

/// What each listed estimate adds.
namespace sph::interpolation {

void cost_of_estimates(report::Run& run) {
    plot::Figure figure{"cost-of-estimates"};
    plot::Panel& panel = figure.panel().titled("2D, cubic spline: only what is listed is computed");
    panel.labels("$h$/d$x$", "CPU time per point [ns]");
    const plot::Values hs = run.quick() ? plot::Values{1.2, 2.0} : plot::Values{1.0, 1.2, 1.5, 2.0, 2.5};
    report::Table table{{"listed", "ns per point at h = 1.2 dx", "at h = 2 dx"}};
    for (const ListedEstimates& list : listed_estimates()) {
        plot::Values times;
        std::vector<std::string> cells{list.name};
        for (const double h_over_dx : hs) {
            times.push_back(list.ns_per_point(run, h_over_dx));
            run.record(list.name + " h=" + report::number(h_over_dx, 2), list.per_side * list.per_side,
                       {{"cpu_ns_per_point", times.back(), "ns"}});
            if (h_over_dx == 1.2 || h_over_dx == 2.0) cells.push_back(report::timing(times.back()));
        }
        panel.curve(hs, times, {.label = list.name, .marker = plot::Marker::circle});
        table.row(cells);
    }
    run.save(figure);
    run.fill("cost-of-estimates", table.markdown());
    run.claim("sharing-pays", [&] {
        const auto at_2 = [&](std::size_t list) { return panel.curves[list].y[hs.size() - 2]; };
        return run.checking() || at_2(2) < 0.9 * (at_2(0) + at_2(1));
    });
}

}  // namespace sph::interpolation
