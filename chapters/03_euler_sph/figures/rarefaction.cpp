#include "chapters/03_euler_sph/scenes/rarefaction.hpp"
#include "common/exact/rarefaction.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {
namespace {

struct Line {
    GasMethod method;
    bool graded;
};
/// All methods with equal masses, and the one with Omega with graded masses too.
std::vector<Line> all_lines() {
    std::vector<Line> lines;
    for (const GasMethod& method : compared_methods()) {
        if (method.name != "super-gaussian") lines.push_back({method, false});
    }
    GasMethod best = lines.back().method;
    best.label += ", graded masses";
    best.look = {.label = best.label, .colour = plot::cycle(5), .marker = plot::Marker::plus};
    lines.push_back({best, true});
    return lines;
}

/// The right half of the particles.
Column right_half(const Column& values) {
    return {values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end()};
}

void draw_exact(plot::Panel& speed, plot::Panel& density) {
    const exact::Rarefaction exact{1, 2, 1.4, 0.5};
    plot::draw_exact(speed, 0, 1.8, [&](double x) { return exact.at(x, 0.4).v; });
    plot::draw_exact(density, 0, exact.front(0.4) * (1 - 1e-9),
                     [&](double x) { return exact.at(x, 0.4).rho; });
}

}  // namespace

void rarefaction(report::Run& run) {
    plot::Figure figure{"rarefaction", 1, 3};
    figure.panel_width = 300;
    plot::Panel& left =
        figure.at(0, 0).titled("200 particles, $t$ = 0.4").labels("$x$", "$v$").x_range(0, 1.8);
    plot::Panel& middle = figure.at(0, 1).log_y().titled("line: exact").labels("$x$", "ρ").x_range(0, 1.8);
    plot::Panel& right = figure.at(0, 2)
                             .log_log()
                             .titled("convergence")
                             .labels("particles $N$", "relative $L$_{1} error of $v$");
    draw_exact(left, middle);
    const auto sizes = run.sizes({50, 100, 200}, {50, 100, 200, 400});
    report::Comparison table{{"h", "masses"},
                             {{"v, N = 200", "l1_v", report::digits(2)},
                              {"ρ, N = 200", "l1_rho", report::digits(2)},
                              {"v, order", "rate_l1_v", report::decimals(1)},
                              {"energy drift", "energy_drift", report::digits(1)}}};
    for (const auto& [method, graded] : all_lines()) {
        const std::string name = method.name + (graded ? " graded" : "");
        plot::Values n, error;
        report::Quantities shown;
        for (const std::size_t size : sizes) {
            RarefactionScene scene;
            scene.n = size;
            scene.graded = graded;
            scene.threads = run.threads();
            const RarefactionRun gas = run_rarefaction(scene, method);
            n.push_back(static_cast<double>(size));
            error.push_back(gas.velocity_error);
            run.record(name, size, gas.measured());
            run.record(name, size, {{"edge_over_front", gas.edge / gas.front}});
            if (size != 200) continue;
            shown = gas.measured();
            if (method.name != "consistent-h" && method.name != "fixed-h") continue;
            left.points(right_half(gas.x), right_half(gas.v), plot::dots(method.look));
            middle.points(right_half(gas.x), right_half(gas.rho), plot::dots(method.look));
        }
        right.curve(n, error, method.look);
        const double order = report::fitted_order(n, error);
        run.record(name, sizes.back(), {{"rate_l1_v", order}});
        shown.push_back({"rate_l1_v", order});
        table.show({method.label, graded ? "graded" : "equal"}, shown);
    }
    left.legend.shown = false;
    middle.legend.shown = false;
    right.legend.outside = true;
    run.save(figure);
    run.fill("rarefaction", table.markdown());
}

}  // namespace sph::euler
