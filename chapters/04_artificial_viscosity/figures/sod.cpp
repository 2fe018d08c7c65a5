#include <algorithm>

#include "chapters/04_artificial_viscosity/figures/tubes.hpp"
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

void draw(report::Run& run, const TubeScene& scene, const std::vector<std::pair<Method<1>, TubeRun>>& tubes) {
    plot::Figure figure{"sod", 2, 2};
    const std::vector<Zoom> zooms{{"", "ρ", &Profile::rho, -0.5, 0.5, 0, 1.15},
                                  {"head of the fan", "ρ", &Profile::rho, -0.28, -0.18, 0.9, 1.04},
                                  {"contact", "$P$", &Profile::p, 0.1, 0.24, 0.28, 0.36},
                                  {"shock", "$v$", &Profile::v, 0.32, 0.38, -0.1, 1.05}};
    for (std::size_t k = 0; k < zooms.size(); ++k) {
        const Zoom& zoom = zooms[k];
        plot::Panel& panel = figure.at(static_cast<int>(k / 2), static_cast<int>(k % 2)).titled(zoom.title);
        panel.labels("$x$", zoom.label).x_range(zoom.low, zoom.high).y_range(zoom.bottom, zoom.top);
        for (const auto& [method, tube] : tubes)
            panel.points(tube.profile.x, tube.profile.*zoom.f, plot::dots(method.styled(), k == 0 ? 2.5 : 4));
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

/// One thing changes from row to row.
std::string story(report::Run& run, const TubeScene& scene,
                  std::vector<std::pair<Method<1>, TubeRun>>& drawn) {
    using namespace report;
    Comparison table{{"viscosity", "kernel, h/dx", "conduction"},
                     {{"ρ %", "l1_rho", in_percent()},
                      {"v %", "l1_v", in_percent()},
                      {"P %", "l1_p", in_percent()},
                      {"spike of P %", "wiggle_p", in_percent()},
                      {"overshoot of ρ %", "overshoot_rho", in_percent()}}};
    const std::string wide = "cubic, 1.2", narrow = "quadratic, 1";
    for (const auto& [name, viscosity, kernel, conduction] :
         {std::tuple{"alpha-beta", "α = 1, β = 2", wide, "none"},
          {"signal", "signal, K = 0.5", wide, "none"},
          {"narrow", "signal, K = 0.85", narrow, "none"},
          {"reconstructed-cubic", "reconstructed", wide, "at contacts"},
          {"reconstructed", "reconstructed", narrow, "at contacts"}}) {
        const Method<1>& method = tube_methods()[name];
        const TubeRun tube = run_tube(scene, method);
        table.show({viscosity, kernel, conduction}, tube.errors());
        if (method.name == "alpha-beta" || method.name == "reconstructed") drawn.emplace_back(method, tube);
    }
    const TubeRun &alpha = drawn[0].second, &best = drawn[1].second;
    run.claim("sod-best", [&] {
        const auto alone = [&](const char* name) { return run_tube(scene, tube_methods()[name]).l1_v; };
        return best.l1_rho < 0.8 * alpha.l1_rho && best.l1_v < 0.6 * alpha.l1_v &&
               best.l1_p < 0.6 * alpha.l1_p && alone("narrow") > 0.7 * alpha.l1_v &&
               alone("reconstructed-cubic") > 0.7 * alpha.l1_v;
    });
    run.claim("sod-head", [&] { return best.overshoot > 0.02 && best.overshoot > alpha.overshoot; });
    return table.markdown();
}

}  // namespace

void sod(report::Run& run) {
    const TubeFigure all{.name = "sod",
                         .scene = {},
                         .more = {"beta-alone", "thermokinetic-all", "none-narrow", "reconstructed-cubic"},
                         .block = "sod-series",
                         .sizes = {180, 360, 720, 900}};
    tube_tables(run, all, 90);
    TubeScene scene;
    scene.n = run.quick() ? 90 : 720;
    std::vector<std::pair<Method<1>, TubeRun>> drawn;
    run.fill("sod-story", story(run, scene, drawn));
    draw(run, scene, drawn);
}

}  // namespace sph::shocks
