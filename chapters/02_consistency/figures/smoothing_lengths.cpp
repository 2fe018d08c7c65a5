#include <algorithm>
#include <map>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/length_rules.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {
namespace {

constexpr std::size_t shown_size = 200;  // whose profiles are drawn

plot::Style rule_style(const LengthRule& rule, std::size_t index) {
    return {.label = rule.label,
            .colour = plot::cycle(index),
            .dash = index < 2 ? plot::Dash::dashed : plot::Dash::solid};
}

void draw_profiles(plot::Figure& figure, const GradedRun& measured, const plot::Style& style) {
    plot::Values scaled = measured.h;
    for (double& h : scaled) h *= static_cast<double>(shown_size);
    figure.at(0, 0).curve(measured.x, scaled, style);
    figure.at(0, 1).curve(measured.x, measured.rho_error, style);
}

/// Runs a rule at all sizes; returns its row of the table.
std::vector<std::string> follow(report::Run& run, plot::Figure& figure, const LengthRule& rule,
                                std::size_t index, const std::vector<std::size_t>& sizes,
                                std::map<std::string, GradedRun>& finest) {
    plot::Style style = rule_style(rule, index);
    plot::Values n, rho;
    GradedRun last;
    for (const std::size_t size : sizes) {
        last = rule.run(size);
        n.push_back(static_cast<double>(size));
        rho.push_back(last.l2_rho);
        run.record(rule.name, size,
                   {{"l2_rho", last.l2_rho},
                    {"l2_value", last.l2_value},
                    {"net_force", last.net_force},
                    {"neighbours", last.neighbours}});
        if (size == shown_size) draw_profiles(figure, last, style);
    }
    style.marker = std::array{plot::Marker::square, plot::Marker::triangle_up, plot::Marker::plus,
                              plot::Marker::circle, plot::Marker::diamond}
                       .at(index);
    figure.at(0, 2).curve(n, rho, style);
    const double rate = report::observed_order(n[n.size() - 2], rho[n.size() - 2], n.back(), rho.back());
    run.record(rule.name, sizes.back(), {{"rate_l2_rho", rate}});
    finest[rule.name] = last;
    return {rule.plain, report::number(rho.back(), 2) + " [" + report::fixed(rate, 1) + "]",
            report::number(last.l2_value, 2),
            last.net_force < 1e-12 ? "0" : report::number(last.net_force, 2),
            report::fixed(last.neighbours, 1)};
}

}  // namespace

void smoothing_lengths(report::Run& run) {
    plot::Figure figure{"smoothing-lengths", 1, 3};
    figure.panel_width = 310;
    figure.panel_height = 260;
    plot::Panel& h = figure.at(0, 0).titled("$h$, 200 particles").log_y();
    plot::Panel& error = figure.at(0, 1).titled("error of ρ, 200 particles");
    plot::Panel& order = figure.at(0, 2).titled("convergence").log_log();
    h.labels("$x$", "$h$ / mean spacing").legend.shown = false;
    error.labels("$x$", "ρ / exact − 1").legend.shown = false;
    order.labels("particles $N$", "rel. $L$_{2} error of ρ").legend.outside = true;
    const std::vector<std::size_t> sizes = run.quick() ? std::vector<std::size_t>{100, 200, 400}
                                                       : std::vector<std::size_t>{100, 200, 400, 800, 1600};
    report::Table table{{"smoothing length", "ρ [order]", "A", "net force", "neighbours"}};
    std::size_t index = 0;
    std::map<std::string, GradedRun> finest;
    for (const LengthRule& rule : length_rules())
        table.row(follow(run, figure, rule, index++, sizes, finest));
    run.save(figure);
    run.fill("smoothing-lengths", table.markdown());
    const auto needs = report::Needs::any_run;
    run.claim(
        "no-single-h", [&] { return finest["global"].l2_rho > 0.03 && finest["mean-density"].l2_rho > 0.03; },
        needs);
    run.claim("own-h-converges", [&] {
        return finest["own-h"].l2_rho < 1e-4 && finest["mean-h"].l2_rho < 1e-4 &&
               finest["mean-kernel"].l2_rho < 1e-4;
    });
    run.claim(
        "gathering-breaks-balance",
        [&] {
            return finest["own-h"].net_force > 0.1 && finest["mean-h"].net_force < 1e-12 &&
                   finest["mean-kernel"].net_force < 1e-12;
        },
        needs);
}

}  // namespace sph::consistency
