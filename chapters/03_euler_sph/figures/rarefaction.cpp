#include "chapters/03_euler_sph/scenes/rarefaction_scene.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"
#include "common/exact/rarefaction.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {

void rarefaction(report::Run& run) {
    plot::Figure figure{"rarefaction", 1, 3};
    figure.panel_width = 300;
    plot::Panel& left = figure.at(0, 0).titled("200 particles, $t$ = 0.4").labels("$x$", "$v$");
    plot::Panel& middle = figure.at(0, 1).log_y().titled("line: exact").labels("$x$", "ρ");
    plot::Panel& right = figure.at(0, 2)
                             .log_log()
                             .titled("convergence")
                             .labels("particles $N$", "relative $L$_{1} error of $v$");
    const exact::Rarefaction exact{1, 2, 1.4, 0.5};
    plot::Values x, v, rho;
    for (int k = 0; k <= 200; ++k) {
        x.push_back(1.8 * k / 200.0);
        const auto state = exact.at(x.back(), 0.4);
        v.push_back(state.v);
        rho.push_back(state.rho);
    }
    left.curve(x, v, exact_line());
    middle.curve(x, rho, exact_line());
    left.x_range(0, 1.8);
    middle.x_range(0, 1.8);
    const std::vector<std::size_t> sizes =
        run.quick() ? std::vector<std::size_t>{50, 100, 200} : std::vector<std::size_t>{50, 100, 200, 400};
    struct Line {
        Named named;
        bool graded;
    };
    std::vector<Line> lines;
    for (const Named& named : compared_schemes()) {
        if (named.name != "super-gaussian") lines.push_back({named, false});
    }
    Named best = lines.back().named;
    best.label += ", graded masses";
    best.style.label = best.label;
    best.style.colour = plot::cycle(5);
    best.style.marker = plot::Marker::plus;
    lines.push_back({best, true});
    report::Table table{{"h", "masses", "v, N = 200", "ρ, N = 200", "v, order", "energy drift"}};
    for (const auto& [named, graded] : lines) {
        plot::Values n, error;
        std::vector<std::string> row;
        for (const std::size_t size : sizes) {
            RarefactionScene scene;
            scene.n = size;
            scene.graded = graded;
            scene.threads = run.threads();
            const RarefactionRun gas = run_rarefaction(scene, named.scheme);
            n.push_back(static_cast<double>(size));
            error.push_back(gas.velocity_error);
            const std::string method = named.name + (graded ? " graded" : "");
            const auto count = static_cast<long>(size);
            run.result(method, count, "l1_v", gas.velocity_error);
            run.result(method, count, "l1_rho", gas.density_error);
            run.result(method, count, "energy_drift", gas.energy_drift);
            run.result(method, count, "momentum_drift", gas.momentum);
            run.result(method, count, "edge_over_front", gas.edge / gas.front);
            if (size != 200) continue;
            row = {named.label,
                   graded ? "graded" : "equal",
                   report::number(gas.velocity_error, 2),
                   report::number(gas.density_error, 2),
                   "",
                   report::number(gas.energy_drift, 1)};
            if (named.name != "consistent-h" && named.name != "fixed-h") continue;
            plot::Values at, speed, density;
            for (std::size_t i = size / 2; i < size; ++i) {
                at.push_back(gas.x[i]);
                speed.push_back(gas.v[i]);
                density.push_back(gas.rho[i]);
            }
            left.points(at, speed, dots(named.style));
            middle.points(at, density, dots(named.style));
        }
        right.curve(n, error, named.style);
        const double order = report::fitted_order(n, error);
        run.result(named.name + (graded ? " graded" : ""), static_cast<long>(sizes.back()), "rate_l1_v",
                   order);
        row[4] = report::fixed(order, 1);
        table.row(row);
    }
    left.legend.shown = false;
    middle.legend.shown = false;
    right.legend.outside = true;
    run.save(figure);
    run.fill("rarefaction", table.markdown());
}

}  // namespace sph::euler
