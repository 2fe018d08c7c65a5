#include <cmath>
#include <map>

#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {
namespace {

void draw_places(plot::Panel& panel, const PlaneMethod& method, std::size_t n, double low) {
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    const auto fluid = plane_fluid(flow, {.n = n, .times = {}}, method);
    const auto& x = fluid->get<Position>();
    plot::Values X, Y;
    constexpr double side = 4;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        if (x[0][i] > low && x[0][i] < low + side && std::abs(x[1][i]) < side / 2)
            X.push_back(x[0][i]), Y.push_back(x[1][i]);
    }
    panel.titled(method.label).labels("$x$", "").x_range(low, low + side).y_range(-side / 2, side / 2);
    panel.equal_aspect = true;
    panel.points(X, Y, plot::dots({.colour = plot::cycle(0), .marker = plot::Marker::circle}, 3));
}

}  // namespace

/// Where particles begin decides what reaches the axis.
void places(report::Run& run) {
    plot::Figure figure{"places", 2, 3};
    figure.panel_width = 280, figure.panel_height = 250;
    const std::size_t shown = run.quick() ? 500 : 2500;
    const std::vector<std::string> drawn{"hexagonal", "rings", "relaxed", "spiral", "spiral-graded"};
    for (std::size_t k = 0; k < drawn.size(); ++k)
        draw_places(figure.at(static_cast<int>(k / 3), static_cast<int>(k % 3)), plane_methods()[drawn[k]],
                    shown, 6.5);
    plot::Panel& inner = figure.at(1, 2);
    draw_places(inner, plane_methods()["rings"], shown, -2);
    inner.titled("rings, at the axis");
    run.save(figure);
}

/// What each of them costs in accuracy, one change at a time.
void methods(report::Run& run) {
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    const std::vector<double> times{2, 5, 10, 15};
    const std::size_t n = run.quick() ? 300 : 10000;
    plot::Figure figure{"methods"};
    plot::Panel& axes = figure.panel().labels("τ", "relative $L$_{1} error of $T$, $r$ < $R$").log_y();
    axes.legend.outside = true;
    report::Table table{{"particles and force", "L1 of T %: τ = 5", "10", "15", "axis %, 10", "axis %, 15"}};
    std::map<std::string, Snapshot> last, middle;
    for (const PlaneMethod& method : plane_methods()) {
        const auto shots = run_plane(flow, {.n = n, .times = times}, method);
        plot::Values error;
        for (const Snapshot& shot : shots) {
            error.push_back(shot.l1_temperature);
            run.record(method.name + " tau=" + report::number(shot.time, 2), shot.x.size(), shot.measured());
        }
        if (method.name != "spiral" && method.name != "rings") axes.curve(times, error, method.styled());
        if (method.name != "relaxed")
            table.row({method.label, report::percent(error[1]), report::percent(error[2]),
                       report::percent(error[3]), report::percent(shots[2].axis),
                       report::percent(shots[3].axis)});
        last[method.name] = shots[3], middle[method.name] = shots[2];
    }
    run.save(figure);
    run.fill("methods", table.markdown());
    const auto l1 = [&](const char* name) { return last.at(name).l1_temperature; };
    run.fill("relaxed-error", report::percent(l1("relaxed")));
    run.fill("corrected-momentum", report::number(last.at("corrected").momentum, 1));
    run.claim("grading-helps", [&] { return l1("spiral-graded") < 0.75 * l1("spiral-solved"); });
    run.claim("omega-costs", [&] { return last.at("spiral-graded").axis < 0.5 * last.at("grad-h").axis; });
    run.claim("fixed-loses", [&] { return l1("fixed-h") > 2 * l1("spiral-graded"); });
    run.claim("corrected-worse", [&] {
        return l1("corrected") > 2 * l1("spiral-graded") && last.at("corrected").momentum > 1e-9;
    });
    run.claim("ring-lattice-noise",
              [&] { return middle.at("rings").axis > 10 * middle.at("hexagonal").axis; });
    run.claim("relaxed-noisy", [&] { return l1("relaxed") > 2 * l1("hexagonal"); });
}

}  // namespace sph::transverse
