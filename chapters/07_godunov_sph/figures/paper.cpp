#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// Figures 2 to 8 of Inutsuka 2002, with their parameters, and what the paper says of them.
namespace sph::godunov {
namespace {

using shocks::TubeRun;
using shocks::TubeScene;

constexpr double few_steps = 0.92;  // the C_CFL with which the paper's 52 steps come out

TubeScene mach() {
    return {.right = {0.5, 0, 0.2}, .n = 120, .courant = few_steps};
}
/// 40 particles on the right: nine times as many in all.
TubeScene sod() {
    return {.n = 360, .courant = 0.5};
}
TubeScene blast() {
    TubeScene scene{{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006, 200};
    scene.courant = 0.5;
    return scene;
}
TubeScene with_courant(TubeScene scene, double courant) {
    scene.courant = courant;
    return scene;
}

struct Panel {
    std::string title;
    Method<1> method;
    TubeScene scene;
    double low, high;  ///< of x
};
std::vector<Panel> panels() {
    const auto& mine = line_methods();
    const Method<1> sph = shocks::tube_methods()["alpha-beta"];
    return {{"2: cubic", mine["inutsuka"], mach(), -0.4, 0.4},
            {"3: SPH, α = 1, β = 2", sph, with_courant(mach(), 0.45), -0.4, 0.4},
            {"4: one $h$ = 0.01", same_h(0.01), mach(), -0.4, 0.4},
            {"5: first order", mine["inutsuka-first"], mach(), -0.4, 0.4},
            {"6: Sod, cubic", mine["inutsuka"], sod(), -0.4, 0.4},
            {"7: blast, cubic", mine["inutsuka"], blast(), -0.5, 0.5},
            {"8: blast, linear", mine["inutsuka-linear"], blast(), -0.5, 0.5}};
}

report::Comparison table() {
    using namespace report;
    return {{"figure"},
            {{"ρ %", "l1_rho", in_percent()},
             {"v %", "l1_v", in_percent()},
             {"P %", "l1_p", in_percent()},
             {"spike of P %", "wiggle_p", in_percent()},
             {"steps", "steps", whole()}}};
}

report::Quantities steps_of(const TubeRun& tube) {
    return {{"steps", static_cast<double>(tube.counters.steps)}};
}

/// Rows of steps: the paper's and what its formulas give.
void steps(report::Run& run, const std::vector<TubeRun>& tubes) {
    const auto count = [](const TubeRun& tube) { return static_cast<double>(tube.counters.steps); };
    const TubeRun stated = run_tube(with_courant(mach(), 0.5), line_methods()["inutsuka"]);
    const TubeRun single = run_tube(mach(), single_precision());
    TubeScene finer = mach();
    finer.n *= 2;
    const TubeRun twice = run_tube(finer, line_methods()["inutsuka"]);
    run.record("inutsuka", finer.n, steps_of(twice));
    run.claim(
        "paper-diffusive", [&] { return count(twice) < 2.1 * count(tubes[0]); }, report::Needs::any_run);
    run.record("inutsuka at 0.5", 120, steps_of(stated));
    run.record("single", 120, single.drifts());
    run.fill("paper-steps", std::to_string(tubes[0].counters.steps));
    run.fill("paper-steps-stated", std::to_string(stated.counters.steps));
    run.fill("paper-steps-sph", std::to_string(tubes[1].counters.steps));
    run.fill("paper-drift-single", report::number(single.energy_drift, 1));
    run.claim(
        "paper-steps", [&] { return count(tubes[0]) < 55 && count(stated) > 70; }, report::Needs::any_run);
    run.claim(
        "paper-sph-steps", [&] { return count(tubes[1]) < 2 * count(tubes[0]); }, report::Needs::any_run);
    run.claim(
        "paper-single",
        [&] {
            return single.energy_drift > 1e-8 && single.energy_drift < 1e-4 && tubes[0].energy_drift < 1e-13;
        },
        report::Needs::any_run);
}

/// The error of ρ with so many steps of the Riemann solver.
double error_after(const TubeScene& scene, double iterations) {
    Method<1> method = line_methods()["inutsuka"];
    method.parameters.set("iterations", iterations);
    return run_tube(scene, method).l1_rho;
}
void iterations(report::Run& run) {
    double largest = 0;
    for (const TubeScene& scene : {mach(), blast()}) {
        const double five = error_after(scene, 5), many = error_after(scene, 40);
        largest = std::max(largest, std::abs(five / many - 1));
        run.record(scene.gamma > 1.5 ? "iterations of the blast" : "iterations of the Mach tube", scene.n,
                   {{"l1_rho_5", five}, {"l1_rho_40", many}});
    }
    run.claim(
        "paper-five", [&] { return largest < 0.002; }, report::Needs::any_run);
}

/// The largest relative error of u in cold gas that no shock has reached, two streams at Mach 1e4 with 24
/// bits; infinite where the run stops.
double cold_error(bool total) {
    TubeScene scene{{1, 1, 1e-8 / 1.4}, {1, -1, 1e-8 / 1.4}, 1.4, 0.1, 100};
    const double u = scene.left.p / (0.4 * scene.left.rho);
    try {
        const TubeRun tube = run_tube(scene, single_precision_energy(total));
        double largest = 0;
        for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
            if (std::abs(tube.profile.x[i]) > 0.2)
                largest = std::max(largest, std::abs(tube.profile.u[i] / u - 1));
        }
        return largest;
    } catch (const Unstable&) {
        return std::numeric_limits<double>::infinity();
    }
}
void energies(report::Run& run) {
    const double of_u = cold_error(false), of_e = cold_error(true);
    run.record("single-u", 100, {{"linf_u_ahead", of_u}});
    run.claim(
        "paper-total-energy", [&] { return of_u < 0.01 && of_e > 1; }, report::Needs::any_run);
}

}  // namespace

void paper(report::Run& run) {
    plot::Figure figure{"paper", 3, 3};
    figure.panel_width = 290, figure.panel_height = 230;
    report::Comparison rows = table();
    std::vector<TubeRun> tubes;
    for (const Panel& one : panels()) {
        const std::size_t k = tubes.size();
        const TubeRun& tube = tubes.emplace_back(run_tube(one.scene, one.method));
        rows.add(run, "figure " + one.title.substr(0, 1), one.scene.n, {one.title},
                 tube.errors() + steps_of(tube));
        const shocks::Profile line = exact_profile(one.scene, one.low, one.high);
        plot::Panel& panel = figure.at(static_cast<int>(k / 3), static_cast<int>(k % 3))
                                 .titled(one.title)
                                 .labels("$x$", "$P$")
                                 .x_range(one.low, one.high);
        panel.curve(line.x, line.p, plot::exact());
        panel.points(tube.profile.x, tube.profile.p, plot::dots(one.method.look, 3));
        panel.legend.shown = false;
    }
    const TubeRun& cubic = tubes[0];
    for (int k = 0; k < 2; ++k) {  // the contact, by (2) and (3)
        const TubeRun& tube = k == 0 ? cubic : tubes[1];
        plot::Panel& panel = figure.at(2, 1 + k)
                                 .titled(k == 0 ? "2, at the contact" : "3, at the contact")
                                 .labels("$x$", "$P$")
                                 .x_range(-0.02, 0.22)
                                 .y_range(0.44, 0.62);
        const shocks::Profile line = exact_profile(mach(), -0.02, 0.22);
        panel.curve(line.x, line.p, plot::exact());
        panel.points(tube.profile.x, tube.profile.p,
                     plot::dots(panels()[static_cast<std::size_t>(k)].method.look, 4));
        panel.legend.shown = false;
    }
    run.save(figure);
    run.fill("paper", rows.markdown());
    run.claim(
        "paper-wiggle", [&] { return tubes[1].wiggle > 4 * cubic.wiggle; }, report::Needs::any_run);
    run.claim(
        "paper-first", [&] { return tubes[3].l1_rho > 1.4 * cubic.l1_rho; }, report::Needs::any_run);
    run.claim(
        "paper-linear", [&] { return tubes[6].wiggle > tubes[5].wiggle; }, report::Needs::any_run);
    steps(run, tubes);
    iterations(run);
    energies(run);
}

}  // namespace sph::godunov
