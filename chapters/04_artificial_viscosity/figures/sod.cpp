#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"
#include "chapters/04_artificial_viscosity/figures/tubes.hpp"
#include "chapters/04_artificial_viscosity/scenes/one_at_a_time.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// Sod's tube by the recommended method, with what is left of its errors; and by every method, as a table.
namespace sph::shocks {
namespace {

struct Zoom {
    std::string title, label;
    Column Profile::*f;
    double low, high;    // of x
    double bottom, top;  // of f
};

void draw(report::Run& run, const TubeScene& scene, const TubeRuns& runs) {
    plot::Figure figure{"sod", 2, 2};
    const std::vector<Zoom> zooms{{"", "ρ", &Profile::rho, -0.5, 0.5, 0, 1.15},
                                  {"head of the fan", "ρ", &Profile::rho, -0.28, -0.18, 0.9, 1.04},
                                  {"contact", "$P$", &Profile::p, 0.1, 0.24, 0.28, 0.36},
                                  {"shock", "$v$", &Profile::v, 0.32, 0.38, -0.1, 1.05}};
    for (std::size_t k = 0; k < zooms.size(); ++k) {
        const Zoom& zoom = zooms[k];
        plot::Panel& panel = figure.at(static_cast<int>(k / 2), static_cast<int>(k % 2)).titled(zoom.title);
        panel.labels("$x$", zoom.label).x_range(zoom.low, zoom.high).y_range(zoom.bottom, zoom.top);
        for (const char* name : {"alpha-beta", "reconstructed"}) {
            const Profile& profile = run_of(runs, name).profile;
            panel.points(profile.x, profile.*zoom.f,
                         plot::dots(tube_methods()[name].styled(), k == 0 ? 2.5 : 4));
        }
        const Profile exact = exact_profile(scene, zoom.low, zoom.high);
        panel.curve(exact.x, exact.*zoom.f, plot::exact());
        panel.legend.shown = k == 0;
    }
    plot::Panel& whole = figure.at(0, 0);
    whole.note(-0.48, 0.5, "fan").points_at = std::array{-0.1, 0.65};
    whole.note(0.2, 0.62, "contact").points_at = std::array{0.185, 0.36};
    whole.note(0.34, 0.45, "shock").points_at = std::array{0.35, 0.22};
    run.save(figure);
}

/// One thing changes from row to row. `narrow_run`: the signal velocity on the narrow kernel, K as on the
/// wide one.
std::string story(const TubeRuns& runs, const TubeRun& narrow_run) {
    using namespace report;
    Comparison table{{"viscosity", "kernel, h/dx", "conduction"},
                     {{"ρ %", "l1_rho", in_percent()},
                      {"v %", "l1_v", in_percent()},
                      {"P %", "l1_p", in_percent()},
                      {"spike of P %", "wiggle_p", in_percent()},
                      {"overshoot of ρ %", "overshoot_rho", in_percent()}}};
    const std::string wide = "cubic, 1.2", narrow = "quadratic, 1";
    for (const auto& [tube, viscosity, kernel, conduction] :
         {std::tuple{&run_of(runs, "alpha-beta"), "α = 1, β = 2", wide, "none"},
          {&run_of(runs, "signal"), "signal, K = 0.5", wide, "none"},
          {&narrow_run, "signal, K = 0.5", narrow, "none"},
          {&run_of(runs, "reconstructed-cubic"), "reconstructed", wide, "at contacts"},
          {&run_of(runs, "reconstructed"), "reconstructed", narrow, "at contacts"}})
        table.show({viscosity, kernel, conduction}, tube->errors());
    return table.markdown();
}

void assert_text(report::Run& run, const TubeScene& scene, const TubeRuns& runs, const TubeRun& narrow) {
    const TubeRun &alpha = run_of(runs, "alpha-beta"), &best = run_of(runs, "reconstructed");
    run.claim("sod-best", [&] {
        return best.l1_rho < 0.8 * alpha.l1_rho && best.l1_v < 0.6 * alpha.l1_v &&
               best.l1_p < 0.6 * alpha.l1_p && narrow.l1_v > 0.6 * alpha.l1_v &&
               narrow.l1_p > 0.6 * alpha.l1_p && run_of(runs, "reconstructed-cubic").l1_v > 0.7 * alpha.l1_v;
    });
    run.claim(
        "sod-head", [&] { return best.overshoot > 0.02 && best.overshoot > alpha.overshoot; },
        report::Needs::any_run);
    run.claim("signal-like-alpha", [&] {
        const auto alike = [](double a, double b) { return std::abs(a / b - 1) < 0.05; };
        const TubeRun& signal = run_of(runs, "signal");
        return alike(signal.l1_rho, alpha.l1_rho) && alike(signal.l1_v, alpha.l1_v) &&
               alike(signal.l1_p, alpha.l1_p);
    });
    run.claim("sod-rings", [&] {
        const auto noise = [&](const TubeRun& tube) { return between_contact_and_shock(tube, scene).noise; };
        return noise(best) > 1.5 * noise(alpha);
    });
    run.claim(
        "energy-rounding",
        [&] {
            return std::all_of(runs.begin(), runs.end(),
                               [](const auto& one) { return one.second.energy_drift < 1e-13; });
        },
        report::Needs::any_run);
}

}  // namespace

void sod(report::Run& run) {
    const TubeFigure all{.name = "sod",
                         .scene = {},
                         .more = {"beta-alone", "thermokinetic-all", "none-narrow", "reconstructed-cubic"},
                         .block = "sod-series",
                         .sizes = {180, 360, 720, 900}};
    const TubeRuns runs = tube_tables(run, all, 90);
    TubeScene scene = all.scene;
    scene.n = run.quick() ? 90 : scene.n;
    scene.threads = run.threads();
    const TubeRun narrow = run_tube(scene, combination({}).line);
    run.fill("sod-story", story(runs, narrow));
    assert_text(run, scene, runs, narrow);
    draw(run, all.scene, runs);
}

}  // namespace sph::shocks
