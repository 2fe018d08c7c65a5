#include "chapters/05_tensile_instability/scenes/rings.hpp"

#include <cmath>
#include <map>

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::tensile {

namespace {

/// What a run leaves that tears apart, or nearly so, has few digits that another compiler would repeat.
std::string to_tens_of_percent(double share) {
    return "about " + report::fixed(10 * std::round(10 * share), 0) + " %";
}

}  // namespace

void rings(report::Run& run) {
    plot::Figure figure{"rings", 1, 3};
    figure.panel_width = 330;
    plot::Panel& energy =
        figure.at(0, 2).titled("energy of motion and strain").labels("$t$", "$E$ / $E$_{0}");
    using namespace report;
    Comparison table{
        {"stress"},
        {{"pieces at the end", "pieces", [](double n) { return n > 3 ? "more than 3" : fixed(n, 0); }},
         {"speed of rebound", "rebound", decimals(1)},
         {"energy left", "energy_left", to_tens_of_percent},
         {"momentum", "momentum_drift", or_word(1e-12, "exact", digits(1))}}};
    std::map<std::string, RingsRun> runs;
    int column = 0;
    for (const SolidMethod& method : solid_methods().named({"jaumann", "artificial-stress"})) {
        RingsScene scene;
        scene.layers = run.quick() ? 3 : 4;
        scene.threads = run.threads();
        const RingsRun& rings = runs[method.name] = run_rings(scene, method);
        plot::Panel& panel = figure.at(0, column++).titled(method.label).labels("$x$", "$y$");
        panel.equal_aspect = true;
        panel.x_range(-11.5, 11.5).y_range(-9, 9);
        plot::Style dots = plot::dots(plot::look_of(method.name), 2);
        dots.marker = plot::Marker::circle;
        panel.points(rings.x[0], rings.x[1], dots);
        plot::Values at, left;
        for (std::size_t k = 0; k < rings.t.size(); k += 10) {
            at.push_back(rings.t[k]);
            left.push_back(rings.energy[k]);
        }
        energy.curve(at, left, plot::line(plot::look_of(method.name, method.label)));
        table.add(run, method.name, rings.n, {method.label}, rings.measured());
    }
    RingsScene few;
    few.threads = run.threads();
    if (!run.quick()) {
        const RingsRun& narrow = runs["jaumann-narrow"] = run_rings(few, with_h("jaumann", "narrow", 0.75));
        run.record("jaumann-narrow", narrow.n, narrow.measured());
    }
    energy.y_range(0, 1.05);
    run.save(figure);
    run.fill("rings", table.markdown());
    const RingsRun &naive = runs["jaumann"], &cured = runs["artificial-stress"];
    run.claim("rings-break", [&] { return naive.pieces > 3 && naive.rebound < 0.3; });
    run.claim("rings-narrow", [&] { return runs["jaumann-narrow"].pieces > 2 * naive.pieces; });
    run.claim("rings-bounce", [&] {
        return cured.pieces == 2 && cured.rebound > 0.5 && cured.energy_left > 0.6 &&
               cured.energy_gain < 0.02;
    });
    run.claim("rings-momentum", [&] { return naive.momentum_drift < 1e-12 && cured.momentum_drift < 1e-12; });
}

}  // namespace sph::tensile
