#include <algorithm>
#include <cmath>

#include "chapters/05_tensile_instability/figures/cures.hpp"
#include "common/report/comparison.hpp"
#include "common/report/text.hpp"

namespace sph::tensile {

namespace {

/// Where a name stands, from its point; with an arrow where that is far.
struct Offset {
    double x = 6, y = 0;
    bool arrow = false;
};
const std::map<std::string, Offset> offsets{
    {"linear-exact", {6, 0.03}},       {"limited", {-85, 0}},          {"stress-xsph", {6, 0.025}},
    {"difference", {6, -0.015}},       {"corrected", {20, 0.1, true}}, {"reference", {10, 0.05, true}},
    {"background", {-30, 0.06, true}}, {"balanced", {-90, 0.06, true}}};

}  // namespace

/// What a rate costs by each method, against the growth that it leaves.
void cure_cost(report::Run& run) {
    CureScene scene = cure_scene(run);
    scene.time = 10;  // the price of a rate is known soon
    plot::Figure figure{"cure-cost"};
    figure.panel_width = 560, figure.panel_height = 340;
    plot::Panel& panel = figure.panel().labels("CPU time of a rate, a particle [ns]", "growth [$c$/dx]");
    std::map<std::string, double> price;
    for (const CureMethod& method : cure_methods()) {
        const double growth =
            std::max(0.0, report::value_of(lattice_merits(method, scene.pressure), "growth"));
        CureRun best = run_cure(scene, method);
        for (int again = 0; again < 2; ++again)
            best.seconds = std::min(best.seconds, run_cure(scene, method).seconds);
        run.record(method.name, scene.n, best.costs());
        const double ns = price[method.name] = best.nanoseconds();
        panel.points({ns}, {growth}, {.colour = plot::cycle(0), .marker = plot::Marker::circle});
        const auto found = offsets.find(method.name);
        const Offset offset = found == offsets.end() ? Offset{} : found->second;
        plot::Note& note = panel.note(ns + offset.x, growth + offset.y, method.label);
        note.size = 7;
        if (offset.arrow) note.points_at = std::array{ns, growth};
    }
    panel.y_range(-0.03, 0.82);
    run.save(figure);
    run.claim("balanced-costs", [&] {
        return price["balanced"] < 5 * price["none"] && price["balanced"] > 1.5 * price["background"];
    });
    run.fill("balanced-price", report::timing(price["balanced"] / price["none"]));
}

}  // namespace sph::tensile
