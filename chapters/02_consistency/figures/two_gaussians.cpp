#include <functional>

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

/// The exact line over a panel of dots.
void draw_exact(plot::Panel& panel, const std::function<double(const Vector<1>&)>& exact) {
    plot::Style line = plot::exact();
    line.width = 0.8;
    line.layer = 3;
    plot::draw_exact(
        panel, 0, 1, [&](double x) { return exact({x}); }, line);
    panel.x_range(0, 1).legend.shown = false;
}

/// A column of panels: the scheme on even particles, and value and slope on random ones.
void draw(plot::Figure& figure, int column, const Estimated<1>& even, const Estimated<1>& random,
          const Scheme<1>& scheme, const Function<1>& function) {
    plot::Panel& top = figure.at(0, column).titled(scheme.label).labels("", column == 0 ? "$A$, even" : "");
    plot::Panel& middle = figure.at(1, column).labels("", column == 0 ? "$A$, random" : "");
    plot::Panel& bottom = figure.at(2, column).labels("$x$", column == 0 ? "d$A$/d$x$, random" : "");
    const plot::Style dots = plot::dots(scheme_style(scheme), 2.5);
    top.points(even.x[0], even.*scheme.value, dots);
    middle.points(random.x[0], random.*scheme.value, dots);
    bottom.points(random.x[0], (random.*scheme.slope)[0], dots);
    for (plot::Panel* panel : {&top, &middle}) {
        draw_exact(*panel, function.value);
        panel->y_range(0, 2);
    }
    draw_exact(bottom, [&](const Vector<1>& x) { return function.gradient(x)[0]; });
    bottom.y_range(-40, 40);
}

ParticleSet particles_of(const report::Run& run, const std::string& arrangement) {
    ParticleSet set{.per_side = particles, .h_over_dx = 2, .jitter = 0.3};  // h = 0.002
    set.seed = run.seed();
    set.threads = run.threads();
    set.arrangement = arrangement_named(arrangement);
    return set;
}

/// Errors of every scheme on every arrangement.
report::Table errors_of(report::Run& run, const Function<1>& function, const std::string& suffix) {
    const auto all = schemes<1>();
    std::vector<std::vector<std::string>> rows;
    for (const auto& scheme : all) rows.push_back({scheme.label});
    for (const std::string& arrangement : arrangement_names()) {
        const auto e = estimate<1>(particles_of(run, arrangement), function);
        for (std::size_t k = 0; k < all.size(); ++k)
            rows[k].push_back(record_errors(run, e, all[k], arrangement + suffix));
        if (arrangement != "random" || !suffix.empty()) continue;
        run.record("repairs random", particles, {{"flagged", static_cast<double>(e.repairs.flagged)}});
        run.fill("repaired", std::to_string(e.repairs.flagged));
    }
    report::Table table{{"scheme", "even: A / slope", "jittered by 0.3 dx", "random"}};
    for (const auto& row : rows) table.row(row);
    return table;
}

}  // namespace

void two_gaussians(report::Run& run) {
    plot::Figure figure{"two-gaussians", 3, 3};
    figure.panel_width = 290;
    figure.panel_height = 200;
    const auto function = sum_of_gaussians<1>(0.4);
    const auto even = estimate<1>(particles_of(run, "even"), function),
               random = estimate<1>(particles_of(run, "random"), function);
    int column = 0;
    for (const auto& scheme : schemes<1>()) {
        if (scheme.value) draw(figure, column++, even, random, scheme, function);
    }
    run.save(figure);
    run.fill("two-gaussians", errors_of(run, function, " pedestal").markdown());
    run.fill("two-gaussians-vanishing", errors_of(run, sum_of_gaussians<1>(), "").markdown());
    const auto all = schemes<1>();
    const auto value = [&](const Estimated<1>& e, std::size_t k) {
        return value_error(e, all[k], Where::everywhere);
    };
    run.claim(
        "ends-spoil-even", [&] { return value(even, 0) > 20 * value(even, 2) && value(even, 4) < 1e-3; },
        report::Needs::any_run);
    run.claim(
        "random-needs-correction",
        [&] {
            return value(random, 0) > 20 * value(random, 2) && value(random, 2) > 5 * value(random, 4) &&
                   slope_error(random, all[0], Where::everywhere) >
                       100 * slope_error(random, all[2], Where::everywhere);
        },
        report::Needs::any_run);
}

}  // namespace sph::consistency
