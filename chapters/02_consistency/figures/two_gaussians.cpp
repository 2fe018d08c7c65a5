#include "chapters/02_consistency/figures/figures.hpp"

namespace sph::consistency {

/// The interpolation of Chen 2017, figs 21 and 22, and of Mota, Chen & Qian 2017, fig. 1.
void two_gaussians(report::Run& run) {
    plot::Figure figure{"two-gaussians", 2, 3};
    figure.panel_width = 330;
    figure.panel_height = 250;
    ParticleSet set;
    set.per_side = 1000;
    set.h_over_dx = 2;  // h = 0.002
    set.jitter = 0.3;
    set.seed = run.seed();
    set.threads = run.threads();
    const auto function = sph::two_gaussians<1>();
    const plot::Values fine = linear_space(0, 1, 401);
    plot::Values exact, exact_slope;
    for (const double x : fine) {
        exact.push_back(function.value({x}));
        exact_slope.push_back(function.gradient({x})[0]);
    }
    std::vector<std::vector<std::string>> rows(schemes<1>().size());
    for (const auto& [arrangement, name] : {std::pair{Arrangement::even, "even"},
                                            {Arrangement::jittered, "jittered"},
                                            {Arrangement::random, "random"}}) {
        set.arrangement = arrangement;
        const auto e = estimate<1>(set, function);
        std::size_t row = 0;
        int column = 0;
        for (const auto& scheme : schemes<1>()) {
            if (rows[row].empty()) rows[row].push_back(scheme.label);
            const std::string method = scheme.name + " " + name;
            std::string text =
                scheme.value ? report::number(value_error(e, scheme, Where::everywhere), 2) : "–";
            text += " / " + report::number(slope_error(e, scheme, Where::everywhere), 2);
            rows[row++].push_back(text);
            if (scheme.value) run.result(method, 1000, "l2_f", value_error(e, scheme, Where::everywhere));
            run.result(method, 1000, "l2_slope", slope_error(e, scheme, Where::everywhere));
            if (arrangement != Arrangement::random || !scheme.value) continue;
            plot::Style dots = scheme_style(scheme);
            dots.label = "1000 random particles";
            dots.width = 0;
            dots.marker_size = 3.5;
            plot::Panel& top = figure.at(0, column).titled(scheme.label).labels("", column == 0 ? "$A$" : "");
            plot::Panel& bottom = figure.at(1, column).labels("$x$", column == 0 ? "d$A$/d$x$" : "");
            top.points(e.x[0], e.*scheme.value, dots);
            bottom.points(e.x[0], (e.*scheme.slope)[0], dots);
            top.curve(fine, exact,
                      {.label = "exact", .colour = plot::Colour{0, 0, 0}, .width = 0.8, .layer = 3});
            bottom.curve(fine, exact_slope,
                         {.label = "exact", .colour = plot::Colour{0, 0, 0}, .width = 0.8, .layer = 3});
            top.x_range(0, 1).y_range(-0.1, 1.45);
            bottom.x_range(0, 1).y_range(-40, 40);
            top.legend.shown = column == 0;
            bottom.legend.shown = false;
            ++column;
        }
        if (arrangement == Arrangement::random) {
            run.result("repairs random", 1000, "flagged", static_cast<double>(e.repairs.flagged));
            run.fill("repaired", std::to_string(e.repairs.flagged));
        }
    }
    report::Table table{{"scheme", "even: A / slope", "jittered by 0.3 dx", "random"}};
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("two-gaussians", table.markdown());
}

}  // namespace sph::consistency
