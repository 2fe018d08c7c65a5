#include "chapters/02_consistency/figures/figures.hpp"

namespace sph::consistency {

void maps(report::Run& run, const Options& options) {
    plot::Figure figure{"maps", 1, 3};
    figure.panel_width = 300;
    figure.panel_height = 300;
    ParticleSet set = options.set(run);
    set.arrangement = Arrangement::jittered;
    set.per_side = 64;
    const auto e = estimate<2>(set, wave<2>());
    double scale = 0;  // the largest slope
    for (std::size_t i = 0; i < e.exact.size(); ++i)
        scale = std::max(scale, std::hypot(e.exact_slope[0][i], e.exact_slope[1][i]));
    int column = 0;
    report::Table table{
        {"∇A on 64² jittered particles", "relative L2 error", "largest error / largest slope"}};
    for (const auto& scheme : schemes<2>()) {
        plot::Values error;
        double worst = 0;
        for (std::size_t i = 0; i < e.exact.size(); ++i) {
            const double miss = std::hypot((e.*scheme.slope)[0][i] - e.exact_slope[0][i],
                                           (e.*scheme.slope)[1][i] - e.exact_slope[1][i]) /
                                scale;
            worst = std::max(worst, miss);
            error.push_back(std::clamp(miss, 1e-4, 1.0));
        }
        const double l2 = slope_error(e, scheme, Where::everywhere);
        run.result(scheme.name, 4096, "l2_slope", l2);
        run.result(scheme.name, 4096, "linf_slope", worst);
        table.row({scheme.label, report::number(l2, 2), report::number(worst, 2)});
        if (scheme.name != "differences" && scheme.name != "by-axes" && scheme.name != "cspm") continue;
        plot::Panel& panel = figure.at(0, column).titled(scheme.label + " (" + scheme.slope_equation + ")");
        plot::Discs discs{
            .name = scheme.name, .x = e.x[0], .y = e.x[1], .value = error, .data_diameter = 1.15 / 64};
        discs.bar = {
            .label = "error of ∇$A$ / largest ∇$A$", .map = plot::Map::viridis, .scale = plot::Scale::log};
        discs.bar.range = {1e-4, 1.0};
        discs.bar.shown = column == 2;
        panel.particles(discs);
        panel.labels("$x$", column == 0 ? "$y$" : "").x_range(0, 1).y_range(0, 1);
        panel.equal_aspect = true;
        panel.grid = false;
        ++column;
    }
    run.save(figure);
    run.fill("maps", table.markdown());
}

}  // namespace sph::consistency
