#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"

#include <algorithm>
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
             {"shock at (0.200)", "shock", decimals(3)},
             {"scatter of ρ [%]", "scatter", digits(1, 100)},
             {"CPU [s]", "cpu_seconds", time_in(1)}}};
}

/// Where the mass puts the shock: the gas of r < R + t at the start is inside, with the mean density rho.
double shock_of(double rho, double time) {
    return time / (std::sqrt(rho) - 1);
}

/// "7", of 0.2139: how many per cent a shock is too far out.
std::string excess(const NohRun& noh, const NohScene& scene) {
    const exact::Noh exact{2, scene.gamma, 1, 1};
    return report::fixed(100 * (noh.shock / exact.shock_position(scene.time) - 1), 0);
}

/// What the text says of the shock, about all runs of the table, and of the grid beside the last of the
/// particles' runs.
void assert_text(report::Run& run, const NohScene& scene, const std::vector<NohRun>& particles,
                 const NohRun& grid) {
    const NohRun &coarse = particles.front(), &fine = particles.back();
    run.fill("noh-shock-coarse", excess(coarse, scene));
    run.fill("noh-shock-fine", excess(fine, scene));
    run.claim("noh-shock", [&] {
        const auto agrees = [&](const NohRun& noh) {
            const double R = exact::Noh{2, scene.gamma, 1, 1}.shock_position(scene.time);
            return noh.shock > 1.02 * R && noh.plateau < 16 &&
                   std::abs(noh.shock / shock_of(noh.plateau, scene.time) - 1) < 0.02;
        };
        return std::all_of(particles.begin(), particles.end(), agrees) && agrees(grid);
    });
    run.claim("noh-rises", [&] {
        const NohRun &signal = particles[1], &finer = particles[particles.size() - 2];
        const NohRun& reconstructed = particles[4];
        return signal.plateau < finer.plateau && reconstructed.plateau < fine.plateau;
    });
    run.claim("noh-centre", [&] {
        return std::all_of(particles.begin(), particles.end(),
                           [](const NohRun& noh) { return noh.centre < 0.75 * noh.plateau; });
    });
    run.claim("noh-cubic", [&] { return particles[5].l1_rho < particles[1].l1_rho; });
    run.claim("noh-colagrossi", [&] {
        return std::all_of(particles.begin(), particles.begin() + 6,
                           [&](const NohRun& noh) { return noh.l1_rho >= particles[3].l1_rho; });
    });
    run.fill("noh-grid-rho", report::number(fine.l1_rho / grid.l1_rho, 2));
    run.fill("noh-grid-v", report::number(fine.l1_v / grid.l1_v, 2));
    // Times are not asserted where only the text is compared: each is measured once, beside whatever runs.
    run.claim("noh-grid", [&] {
        return grid.l1_rho < fine.l1_rho && grid.l1_v < fine.l1_v &&
               (run.checking() || 100 * grid.seconds < fine.seconds);
    });
}

}  // namespace

void noh_plane(report::Run& run) {
    NohScene scene;
    scene.n = run.quick() ? 16 : 40;
    report::Comparison table = noh_table();
    std::vector<NohRun> particles;
    const auto add = [&](const Method<2>& method) {
        particles.push_back(run_noh(scene, method));
        const NohRun& noh = particles.back();
        table.add(run, method.name, noh.r.size(), {method.label, std::to_string(noh.r.size())},
                  noh.measured() + report::Quantities{{"energy_drift", noh.energy_drift}});
    };
    for (const Method<2>& method : plane_methods().named(
             {"alpha-beta", "signal", "balsara", "colagrossi", "reconstructed", "signal-cubic"}))
        add(method);
    scene.n = run.quick() ? 20 : 50;
    const Method<2>&signal = plane_methods()["signal"], &best = plane_methods()["reconstructed"];
    add(signal), add(best);
    const NohRun &plain = *(particles.end() - 2), &fine = particles.back();
    const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(fine.r.size())));
    const NohRun grid = run_noh_grid(scene, cells);
    table.add(run, "grid", grid.r.size(), {"grid", std::to_string(grid.r.size())}, grid.measured());
    run.fill("noh-plane", table.markdown());
    assert_text(run, scene, particles, grid);

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
