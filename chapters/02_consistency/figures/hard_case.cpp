#include <algorithm>
#include <cmath>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/hard_sets.hpp"

namespace sph::consistency {
namespace {

double miss(const Vector<2>& slope, const Vector<2>& exact) {
    return std::hypot(slope[0] - exact[0], slope[1] - exact[1]);
}

/// A slope as text. What is not a number, or off by half of the exact slope, is "meaningless": which digits
/// it has is a matter of rounding.
std::string shown(const Vector<2>& slope, const Vector<2>& exact, bool naive) {
    const double error = miss(slope, exact);
    if (naive && !(error < 0.5 * std::hypot(exact[0], exact[1]))) return "meaningless";
    const auto digits = [](double s) { return report::number(std::abs(s) < 1e-12 ? 0 : s, 2); };
    return "(" + digits(slope[0]) + ", " + digits(slope[1]) + ")";
}

/// Slopes of a curved function from neighbours on a band of decreasing width.
void nearly_collinear(report::Run& run, plot::Panel& panel) {
    plot::Values width, naive, guarded;
    for (const double w : log_space(1e-8, 1, run.quick() ? 9 : 33)) {
        const HardSlopes s = hard_slopes(band(w));
        width.push_back(w);
        naive.push_back(miss(s.naive, s.exact));
        guarded.push_back(miss(s.guarded, s.exact));
    }
    run.result("naive", 7, "largest_slope_error", *std::max_element(naive.begin(), naive.end()), "absolute");
    run.result("guarded", 7, "largest_slope_error", *std::max_element(guarded.begin(), guarded.end()),
               "absolute");
    panel.titled("neighbours nearly on a line, 2D").log_log();
    panel.labels("width of their band / $h$", "error of ∇$A$ (|∇$A$| = 1.4)");
    panel.curve(width, naive,
                {.label = "naive (2.4)", .colour = plot::cycle(1), .marker = plot::Marker::square});
    panel.curve(width, guarded, {.label = "guarded", .marker = plot::Marker::circle});
}

/// The worst slope on random particles, some of which have no neighbours to speak of.
void too_few_neighbours(report::Run& run, plot::Panel& panel) {
    constexpr double meaningless = 1e12;  // where it is drawn
    plot::Values n, naive, guarded, repaired;
    std::size_t flagged = 0, lost = 0, all = 0;
    for (const std::size_t side : run.quick() ? std::vector<std::size_t>{16, 32}
                                              : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128}) {
        const RandomPlane plane = random_plane(side, run.seed());
        const auto count = static_cast<long>(side * side);
        n.push_back(static_cast<double>(side));
        naive.push_back(std::min(plane.naive, meaningless));
        guarded.push_back(plane.guarded);
        repaired.push_back(plane.repaired);
        run.result("naive random", count, "singular", static_cast<double>(plane.singular));
        run.result("guarded random", count, "linf_slope", plane.guarded);
        run.result("repaired random", count, "linf_slope", plane.repaired);
        run.result("repaired random", count, "left", static_cast<double>(plane.repairs.left));
        flagged += plane.repairs.flagged;
        lost += plane.singular;
        all += side * side;
    }
    run.fill("flagged", report::percent(static_cast<double>(flagged) / static_cast<double>(all)));
    run.fill("lost", std::to_string(lost));
    run.fill("of-all", std::to_string(all));
    run.claim(
        "repair-helps",
        [&] {
            for (std::size_t k = 0; k < n.size(); ++k) {
                if (repaired[k] > guarded[k] || naive[k] < meaningless) return false;
            }
            return true;
        },
        report::Needs::any_run);
    panel.titled("random particles, 2D").log_log();
    panel.labels("particles along a side", "largest error / largest slope").y_range(1e-2, 1e13);
    panel.curve(
        n, naive,
        {.label = "naive (10^{12}: meaningless)", .colour = plot::cycle(1), .marker = plot::Marker::square});
    panel.curve(n, guarded, {.label = "guarded", .marker = plot::Marker::circle});
    panel.curve(
        n, repaired,
        {.label = "guarded, $h$ enlarged", .colour = plot::cycle(2), .marker = plot::Marker::diamond});
}

}  // namespace

void hard_case(report::Run& run) {
    plot::Figure figure{"hard-case", 1, 2};
    nearly_collinear(run, figure.at(0, 0));
    too_few_neighbours(run, figure.at(0, 1));
    run.save(figure);
    report::Table table{
        {"neighbours", "naive, CSPM", "naive, least squares", "guarded, CSPM", "guarded, least squares"}};
    for (const HardSet& set : hard_sets()) {
        const HardSlopes s = hard_slopes(set);
        table.row({set.name, shown(s.naive, s.exact, true), shown(s.naive_linear, s.exact, true),
                   shown(s.guarded, s.exact, false), shown(s.guarded_linear, s.exact, false)});
    }
    run.fill("hard-case", table.markdown());
    const auto sets = hard_sets();
    const auto needs = report::Needs::any_run;
    run.claim(
        "naive-is-meaningless",
        [&] {
            return std::all_of(sets.begin(), sets.end(), [](const HardSet& set) {
                const HardSlopes s = hard_slopes(set);
                return shown(s.naive, s.exact, true) == "meaningless" &&
                       shown(s.naive_linear, s.exact, true) == "meaningless";
            });
        },
        needs);
    run.claim(
        "guarded-is-bounded",
        [&] {
            return std::all_of(sets.begin(), sets.end(), [](const HardSet& set) {
                const HardSlopes s = hard_slopes(set);
                return miss(s.guarded, s.exact) < 1.415 && miss(s.guarded_linear, s.exact) < 1.415;
            });
        },
        needs);
}

}  // namespace sph::consistency
