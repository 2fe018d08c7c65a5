#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/scheme_times.hpp"

/// What each scheme adds to the cost of a point.
namespace sph::consistency {

void cost_of_schemes(report::Run& run) {
    plot::Figure figure{"cost-of-schemes"};
    plot::Panel& panel =
        figure.panel().titled("2D, quintic spline, one core").labels("$h$/d$x$", "CPU time per point [ns]");
    panel.legend.outside = true;
    const plot::Values hs = run.quick() ? plot::Values{1, 1.2, 2} : plot::Values{1, 1.2, 1.5, 2};
    report::Table table{{"listed", "ns per point at h = 1.2 dx", "at h = 2 dx"}};
    ParticleSet set{.arrangement = Arrangement::jittered, .per_side = 64};
    std::size_t index = 0;
    for (const ListedSchemes& listed : listed_schemes()) {
        plot::Values times;
        std::vector<std::string> row{listed.label};
        for (const double h_over_dx : hs) {
            set.h_over_dx = h_over_dx;
            times.push_back(listed.ns_per_point(run, set));
            run.record(listed.label + " h=" + report::number(h_over_dx, 2), set.per_side * set.per_side,
                       {{"cpu_ns_per_point", times.back(), "ns"}});
            if (h_over_dx == 1.2 || h_over_dx == 2) row.push_back(report::timing(times.back()));
        }
        table.row(row);
        panel.curve(hs, times,
                    {.label = listed.label, .colour = plot::cycle(index), .marker = plot::Marker::circle});
        ++index;
    }
    run.save(figure);
    run.fill("cost-of-schemes", table.markdown());
    // CSPM's slope over that of differences.
    const plot::Values &plain = panel.curves[2].y, &corrected = panel.curves[3].y;
    run.fill("price", report::timing(corrected[1] / plain[1]));  // at h = 1.2 dx
    run.claim("correction-is-cheap", [&] {
        return run.checking() || (corrected[1] < 1.6 * plain[1] && corrected.back() < 1.6 * plain.back());
    });
    run.fill("price-at-2", report::timing(corrected.back() / plain.back()));
}

}  // namespace sph::consistency
