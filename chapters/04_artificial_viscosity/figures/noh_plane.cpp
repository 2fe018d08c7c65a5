#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"

#include <cmath>

#include "chapters/04_artificial_viscosity/figures/plane.hpp"
#include "common/exact/noh.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

report::Comparison noh_table() {
    using namespace report;
    return {{"method", "N"},
            {{"ρ, L₁", "l1_rho", digits(2)},
             {"v, L₁", "l1_v", digits(2)},
             {"ρ behind the shock (16)", "plateau", digits(3)},
             {"ρ at the centre", "centre", digits(2)},
             {"scatter of ρ [%]", "scatter", digits(1, 100)},
             {"CPU [s]", "cpu_seconds", time_in(1)}}};
}

}  // namespace

void noh_plane(report::Run& run) {
    NohScene scene;
    scene.n = run.quick() ? 16 : 40;
    report::Comparison table = noh_table();
    const auto add = [&](const Method<2>& method) {
        const NohRun noh = run_noh(scene, method);
        table.add(run, method.name, noh.r.size(), {method.label, std::to_string(noh.r.size())},
                  noh.measured() + report::Quantities{{"energy_drift", noh.energy_drift}});
        return noh;
    };
    for (const Method<2>& method : plane_methods().named(
             {"alpha-beta", "signal", "balsara", "colagrossi", "reconstructed", "signal-cubic"}))
        add(method);
    scene.n = run.quick() ? 20 : 50;
    const Method<2>&signal = plane_methods()["signal"], &best = plane_methods()["reconstructed"];
    const NohRun plain = add(signal), fine = add(best);
    const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(fine.r.size())));
    const NohRun grid = run_noh_grid(scene, cells);
    table.add(run, "grid", grid.r.size(), {"grid", std::to_string(grid.r.size())}, grid.measured());
    run.fill("noh-plane", table.markdown());

    plot::Figure figure{"noh-plane", 1, 3};
    figure.panel_width = 330;
    const double side = 0.3;
    draw_map(figure.at(0, 0).titled("reconstructed"), {fine.x, fine.r, fine.rho}, side, 18, 3);
    figure.at(0, 0).discs.back().bar.shown = false;
    draw_map(figure.at(0, 1).titled("signal velocity"), {plain.x, plain.r, plain.rho}, side, 18, 3);
    plot::Panel& profile = figure.at(0, 2).labels("$r$", "ρ").x_range(0, 0.35).y_range(0, 19);
    draw_profile(profile, {plain.x, plain.r, plain.rho}, 0.35, signal.styled());
    draw_profile(profile, {fine.x, fine.r, fine.rho}, 0.35, best.styled());
    draw_profile(profile, {grid.x, grid.r, grid.rho}, 0.35, plot::competitor("grid"));
    const exact::Noh exact{2, scene.gamma, 1, 1};
    plot::draw_exact(profile, 0, 0.35, [&](double r) { return exact.at(r, scene.time).rho; }).style.layer = 2;
    run.save(figure);
}

}  // namespace sph::shocks
