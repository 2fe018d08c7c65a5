#include "chapters/05_tensile_instability/scenes/wheel.hpp"

#include <cmath>
#include <map>

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::tensile {
namespace {

void draw_places(plot::Panel& panel, const std::string& title, const WheelRun& wheel) {
    panel.titled(title).labels("$x$", "$y$");
    panel.equal_aspect = true;
    panel.particles({.name = title,
                     .x = wheel.x[0],
                     .y = wheel.x[1],
                     .value = wheel.angle,
                     .diameter = 5,
                     .bar = {.label = "angle at first", .map = plot::Map::viridis, .shown = false}});
}

/// |L/L_0 - 1|; steps at which not a bit has changed have no place on a logarithmic axis.
void draw_change(plot::Panel& panel, const SolidMethod& method, const WheelRun& wheel) {
    plot::Values at, change;
    for (std::size_t k = 0; k < wheel.t.size(); k += 20) {
        if (wheel.change[k] == 0) continue;
        at.push_back(wheel.t[k]);
        change.push_back(std::abs(wheel.change[k]));
    }
    panel.curve(at, change, plot::line(plot::look_of(method.name, method.label)));
}

report::Shown or_small(const report::Shown& otherwise) {
    return [otherwise](double value) {
        const double size = std::abs(value);
        return size < 1e-12 ? "rounding" : size < 1e-3 ? "below 0.001" : otherwise(value);
    };
}

}  // namespace

void wheel(report::Run& run) {
    plot::Figure figure{"wheel", 1, 3};
    figure.panel_width = 330;
    plot::Panel& change = figure.at(0, 2).log_y().titled("angular momentum").labels("turns", "|ℒ/ℒ_{0} − 1|");
    using namespace report;
    // What a run of torn matter does has few digits that another compiler would repeat.
    const Shown first = or_small(decimals(2)), later = or_small(decimals(1));
    Comparison table{{"stress"},
                     {{"change of ℒ after half a turn", "after_half", first},
                      {"after one turn", "after_one", later},
                      {"largest in ten turns", "angular_momentum_drift", later}}};
    std::map<std::string, WheelRun> runs;
    for (const SolidMethod& method : solid_methods().without({"artificial-stress"})) {
        WheelScene scene;
        scene.threads = run.threads();
        if (run.quick()) scene.turns = 2;
        const WheelRun& wheel = runs[method.name] = run_wheel(scene, method);
        draw_change(change, method, wheel);
        table.add(run, method.name, wheel.n, {method.label}, wheel.measured());
    }
    WheelScene one_turn;
    one_turn.turns = 1;
    one_turn.threads = run.threads();
    draw_places(figure.at(0, 0), "as printed, after one turn",
                run_wheel(one_turn, solid_methods()["jaumann"]));
    draw_places(figure.at(0, 1), run.quick() ? "total Lagrangian" : "total Lagrangian, after ten",
                runs["total-lagrangian"]);
    run.save(figure);
    run.fill("wheel", table.markdown());
    const Tensor<2> rim = lattice_matrix(1.5, 0);
    run.fill("rim-along", fixed(rim[0][0], 2));
    run.fill("rim-across", fixed(rim[1][1], 2));
    run.claim(
        "wheel-printed-loses", [&] { return runs["jaumann"].after_one < -0.5; }, report::Needs::any_run);
    run.claim("wheel-xsph-delays", [&] {
        return runs["strong-xsph"].after_half > 0.7 * runs["jaumann"].after_half &&
               runs["strong-xsph"].loss > 0.5;
    });
    run.claim("wheel-corrected-keeps",
              [&] { return runs["corrected-rate"].loss < 1e-3 && runs["corrected-rate"].loss > 1e-12; });
    run.claim("wheel-exact", [&] {
        const WheelRun& exact = runs["total-lagrangian"];
        return exact.turns > 9.99 && exact.loss < 1e-12 && exact.energy_drift < 1e-3;
    });
}

}  // namespace sph::tensile
