#include "chapters/09_transverse_expansion/scenes/bjorken.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"

namespace sph::transverse {

/// Bjorken's flow at rest and drifting: what a momentum does whose inertia cools.
void bjorken(report::Run& run) {
    plot::Figure figure{"bjorken", 1, 2};
    plot::Panel& T = figure.at(0, 0).log_log().labels("τ", "$T$/$T$_{0}");
    plot::Panel& u = figure.at(0, 1).log_log().labels("τ", "$u$^{x}");
    u.legend.shown = false;
    std::vector<double> times;
    for (int k = 1; k <= 9; ++k) times.push_back(std::pow(8, k / 9.0));
    double worst = 0, slowest = 1;
    std::size_t look = 0;
    for (const double u0 : {0.0, 0.3, 1.0}) {
        const BjorkenRun flow = run_bjorken({.u = u0, .times = times});
        const plot::Style style{.label = "$u$_{0} = " + report::number(u0, 1),
                                .colour = plot::cycle(look++),
                                .marker = plot::Marker::circle};
        T.curve(times, flow.exact_temperature, {.colour = plot::black, .width = 1});
        T.points(times, flow.temperature, plot::dots(style, 5));
        if (u0 > 0) {
            u.curve(times, flow.exact_u, {.colour = plot::black, .width = 1});
            u.points(times, flow.u, plot::dots(style, 5));
            slowest = std::min(slowest, flow.u.front() / u0 > 1 ? 1.0 : 0.0);
        }
        worst = std::max(worst, flow.error);
        run.record("u0=" + report::number(u0, 1), 256, {{"linf_temperature", flow.error}});
    }
    run.save(figure);
    run.claim(
        "bjorken-exact", [&] { return worst < 1e-9; }, report::Needs::any_run);
    run.claim(
        "bjorken-speeds-up", [&] { return slowest > 0; }, report::Needs::any_run);
}

}  // namespace sph::transverse
