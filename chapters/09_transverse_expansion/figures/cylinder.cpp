#include "chapters/09_transverse_expansion/scenes/expansion.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"

namespace sph::transverse {
namespace {

/// Every stride-th particle.
plot::Values thinned(const Column& values, std::size_t stride) {
    plot::Values kept;
    for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
    return kept;
}

}  // namespace

/// T/T0 against r at four times: the last figure of the thesis.
void cylinder_profiles(report::Run& run) {
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    const std::vector<double> times{1.001, 5, 10, 15};
    const std::size_t n = run.quick() ? 1000 : 10000;
    const auto shots = run_plane(flow, {.n = n, .times = times}, plane_methods().recommended());
    plot::Figure figure{"cylinder", 1, 2};
    plot::Panel& T = figure.at(0, 0).labels("$r$", "$T$/$T$_{0}").x_range(0, 25).y_range(0, 1.1);
    plot::Panel& error =
        figure.at(0, 1).labels("$r$", "$T$/$T$_{exact} – 1, %").x_range(0, 10).y_range(-4, 4);
    error.legend.shown = false;
    report::Table table{{"τ", "L1 of T %", "L1 of u %", "axis %", "momentum", "entropy", "steps"}};
    double worst = 0, axis = 0;
    for (std::size_t k = 0; k < shots.size(); ++k) {
        const Snapshot& shot = shots[k];
        const FlowProfile exact = flow.exact(shot.time);
        const std::string label = "τ = " + report::number(shot.time, 2);
        const plot::Style look{.label = label, .colour = plot::cycle(k), .marker = plot::Marker::circle};
        const double edge = 10 + shot.time - 1;
        plot::draw_exact(T, 0, edge * 0.9999, [&](double r) { return exact(r).temperature; },
                         {.label = k == 0 ? "exact" : "", .colour = plot::black, .width = 1, .layer = 2});
        const std::size_t stride = std::max<std::size_t>(1, n / 400);
        T.points(thinned(shot.r, stride), thinned(shot.temperature, stride), plot::dots(look, 3));
        if (k == 0) continue;  // nothing has happened yet
        plot::Values relative;
        for (std::size_t i = 0; i < shot.r.size(); ++i)
            relative.push_back(100 * (shot.temperature[i] / std::max(shot.exact_temperature[i], 1e-9) - 1));
        plot::Values r, inside;
        for (std::size_t i = 0; i < relative.size(); i += 2) {
            if (shot.r[i] < 10 && std::abs(relative[i]) < 4)
                r.push_back(shot.r[i]), inside.push_back(relative[i]);
        }
        error.points(r, inside, plot::dots(look, 2));
        worst = std::max(worst, shot.l1_temperature), axis = std::max(axis, shot.axis);
        run.record("spiral-graded tau=" + report::number(shot.time, 2), shot.x.size(), shot.measured());
        table.row(
            {report::number(shot.time, 2), report::percent(shot.l1_temperature), report::percent(shot.l1_u),
             report::percent(shot.axis), report::below(std::max(shot.momentum, 1e-15)),
             report::below(std::max(std::abs(shot.entropy), 1e-15)), std::to_string(shot.counters.steps)});
    }
    run.save(figure);
    run.fill("cylinder", table.markdown());
    run.claim("cylinder-good", [&] { return worst < 5e-3 && axis < 0.02; });
    run.claim("cylinder-conserves", [&] {
        return std::all_of(shots.begin(), shots.end(), [](const Snapshot& shot) {
            return shot.momentum < 1e-14 && std::abs(shot.entropy) < 1e-12;
        });
    });
}

}  // namespace sph::transverse
