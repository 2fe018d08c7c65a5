#include "chapters/05_tensile_instability/scenes/criterion.hpp"

#include <algorithm>

#include "common/plot/looks.hpp"

namespace sph::tensile {
namespace {

/// Growth of the cubic spline's lattice against h, and where the criterion says "unstable".
template <int d>
void draw_growth(plot::Panel& panel) {
    panel.titled(d == 1 ? "a line, cubic spline" : "the plane, cubic spline")
        .labels("$h$ / d$x$", "fastest growth / ($c$/d$x$)");
    for (const double P : {-0.2, 0.2}) {
        plot::Values h, rate;
        for (int n = 0; n <= 97; ++n) {
            h.push_back(0.55 + 0.025 * n);
            rate.push_back(
                growth_on_grid<d>(named_lattice<d>("cubic", h.back()), isotropic<d>(P), d == 1 ? 200 : 24));
        }
        panel.curve(h, rate,
                    {.label = P < 0 ? "tension, $P$ = −0.2" : "pressure, $P$ = 0.2",
                     .colour = plot::cycle(P < 0 ? 0 : 1)});
    }
    panel.band({0.5, 1.5}, {0, 0}, {1, 1}, "called unstable under tension");
    panel.y_range(-0.02, 1).x_range(0.5, 3);
}

struct Count {
    int states = 0, unstable = 0, called = 0, missed = 0, false_alarms = 0;
};
Count count(const std::vector<Verdict>& verdicts, bool tension) {
    Count counted;
    for (const Verdict& one : verdicts) {
        if ((one.pressure < 0) != tension) continue;
        ++counted.states;
        counted.unstable += one.unstable() ? 1 : 0;
        counted.called += one.called ? 1 : 0;
        counted.missed += one.missed() ? 1 : 0;
        counted.false_alarms += one.false_alarm() ? 1 : 0;
    }
    return counted;
}

}  // namespace

void criterion(report::Run& run) {
    const std::vector<double> h{0.8, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3},
        pressures{-0.5, -0.2, -0.05, 0.05, 0.2, 0.5};
    plot::Figure figure{"criterion", 1, 2};
    draw_growth<1>(figure.at(0, 0));
    draw_growth<2>(figure.at(0, 1));
    figure.at(0, 1).legend.shown = false;
    run.save(figure);
    const auto line = verdicts<1>(h, pressures), plane = verdicts<2>(h, pressures);
    report::Table table{{"lattice", "stress", "states", "unstable", "called so", "missed", "false alarms"}};
    std::vector<Count> counts;
    for (const bool tension : {true, false}) {
        for (const int d : {1, 2}) {
            const Count& one = counts.emplace_back(count(d == 1 ? line : plane, tension));
            table.row({d == 1 ? "line" : "square", tension ? "tension" : "pressure",
                       std::to_string(one.states), std::to_string(one.unstable), std::to_string(one.called),
                       std::to_string(one.missed), std::to_string(one.false_alarms)});
            run.record(std::string{tension ? "tension" : "pressure"} + (d == 1 ? " line" : " square"),
                       static_cast<std::size_t>(one.states),
                       {{"unstable", double(one.unstable)},
                        {"called", double(one.called)},
                        {"missed", double(one.missed)},
                        {"false_alarms", double(one.false_alarms)}});
        }
    }
    run.fill("criterion", table.markdown());
    run.claim(
        "criterion-tension",
        [&] {
            return counts[0].unstable == counts[0].states && counts[1].unstable == counts[1].states &&
                   counts[0].false_alarms + counts[1].false_alarms == 0;
        },
        report::Needs::any_run);
    run.claim(
        "criterion-misses",
        [&] {
            return 5 * counts[1].missed > 2 * counts[1].unstable && 2 * counts[3].missed > counts[3].unstable;
        },
        report::Needs::any_run);
    run.claim(
        "criterion-line", [&] { return counts[2].false_alarms > 0.9 * counts[2].called; },
        report::Needs::any_run);
}

}  // namespace sph::tensile
