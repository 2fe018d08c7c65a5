#include "chapters/02_consistency/figures/figures.hpp"
#include "common/plot/looks.hpp"

/// The interpolation of Chen 2017, figs 21 and 22, and of Mota, Chen & Qian 2017, fig. 1.
namespace sph::consistency {
namespace {

constexpr std::size_t particles = 1000;

/// "value / slope" of one scheme, and its rows.
std::string record_errors(report::Run& run, const Estimated<1>& e, const Scheme<1>& scheme,
                          const std::string& arrangement) {
    const double slope = slope_error(e, scheme, Where::everywhere);
    const std::string method = scheme.name + " " + arrangement;
    run.record(method, particles, {{"l2_slope", slope}});
    if (!scheme.value) return "– / " + report::number(slope, 2);
    const double value = value_error(e, scheme, Where::everywhere);
    run.record(method, particles, {{"l2_f", value}});
    return report::number(value, 2) + " / " + report::number(slope, 2);
}

/// A column of panels: the scheme on random particles, and the exact function over it.
void draw(plot::Figure& figure, int column, const Estimated<1>& e, const Scheme<1>& scheme,
          const Function<1>& function) {
    plot::Panel& top = figure.at(0, column).titled(scheme.label).labels("", column == 0 ? "$A$" : "");
    plot::Panel& bottom = figure.at(1, column).labels("$x$", column == 0 ? "d$A$/d$x$" : "");
    plot::Style dots = plot::dots(scheme_style(scheme));
    dots.label = "1000 random particles";
    top.points(e.x[0], e.*scheme.value, dots);
    bottom.points(e.x[0], (e.*scheme.slope)[0], dots);
    const plot::Values fine = linear_space(0, 1, 401);
    plot::Values exact, exact_slope;
    for (const double x : fine) {
        exact.push_back(function.value({x}));
        exact_slope.push_back(function.gradient({x})[0]);
    }
    plot::Style line = plot::exact();
    line.width = 0.8;
    line.layer = 3;
    top.curve(fine, exact, line);
    bottom.curve(fine, exact_slope, line);
    top.x_range(0, 1).y_range(-0.1, 1.45);
    bottom.x_range(0, 1).y_range(-40, 40);
    top.legend.shown = column == 0;
    bottom.legend.shown = false;
}

}  // namespace

void two_gaussians(report::Run& run) {
    plot::Figure figure{"two-gaussians", 2, 3};
    figure.panel_width = 330;
    figure.panel_height = 250;
    ParticleSet set{.per_side = particles, .h_over_dx = 2, .jitter = 0.3};  // h = 0.002
    set.seed = run.seed();
    set.threads = run.threads();
    const auto function = sum_of_gaussians<1>();
    const auto all = schemes<1>();
    std::vector<std::vector<std::string>> rows;
    for (const auto& scheme : all) rows.push_back({scheme.label});
    for (const std::string& arrangement : arrangement_names()) {
        set.arrangement = arrangement_named(arrangement);
        const auto e = estimate<1>(set, function);
        int column = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            rows[k].push_back(record_errors(run, e, all[k], arrangement));
            if (arrangement == "random" && all[k].value) draw(figure, column++, e, all[k], function);
        }
        if (arrangement != "random") continue;
        run.record("repairs random", particles, {{"flagged", static_cast<double>(e.repairs.flagged)}});
        run.fill("repaired", std::to_string(e.repairs.flagged));
    }
    report::Table table{{"scheme", "even: A / slope", "jittered by 0.3 dx", "random"}};
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("two-gaussians", table.markdown());
}

}  // namespace sph::consistency
