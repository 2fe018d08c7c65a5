#include "common/exact/sedov.hpp"

#include <cmath>

#include "chapters/04_artificial_viscosity/figures/plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/sedov_plane.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

report::Comparison sedov_table() {
    using namespace report;
    return {{"method", "N"},
            {{"ρ, L₁", "l1_rho", digits(2)},
             {"v, L₁", "l1_v", digits(2)},
             {"P, L₁", "l1_p", digits(2)},
             {"shock at (0.4)", "shock_radius", decimals(3)},
             {"peak / exact", "peak", digits(2)},
             {"CPU [s]", "cpu_seconds", time_in(1)}}};
}

}  // namespace

void sedov(report::Run& run) {
    SedovScene scene;
    scene.n = run.quick() ? 16 : 40;
    scene.most_steps = 400;  // methods that finish need 270
    report::Comparison table = sedov_table();
    const auto add = [&](const SedovScene& one, const Method<2>& method, const std::string& name,
                         const std::string& label) {
        SedovRun blast = run_sedov(one, method);
        table.add(run, name, blast.r.size(), {label, std::to_string(blast.r.size())},
                  blast.measured() + report::Quantities{{"energy_drift", blast.energy_drift}});
        return blast;
    };
    std::vector<std::string> finished;
    for (const Method<2>& method :
         plane_methods().named({"alpha-beta", "signal", "balsara", "colagrossi", "reconstructed"})) {
        try {
            add(scene, method, method.name, method.label);
            finished.push_back(method.name);
        } catch (const Unstable&) {
            table.add_words({method.label, std::to_string(scene.n * scene.n), "stops"});
        }
    }
    scene.n = run.quick() ? 20 : 60;
    scene.most_steps = SedovScene{}.most_steps;
    const Method<2>& signal = plane_methods()["signal"];
    const SedovRun fine = add(scene, signal, signal.name, signal.label);
    SedovScene other = scene;
    other.n = scene.n / 2;
    other.quarter = false;
    other.lattice = Lattice::hexagonal;
    add(other, signal, "signal hexagonal", "the same, hexagonal, whole plane");
    const SedovRun grid = run_sedov_grid(scene);
    table.add(run, "grid", grid.r.size(), {"grid", std::to_string(grid.r.size())}, grid.measured());
    run.fill("sedov", table.markdown());
    run.claim("sedov-shock", [&] {
        return std::abs(fine.shock_radius / scene.radius - 1) < 0.02 && fine.peak > 0.78 && fine.peak < 0.88;
    });
    run.claim("sedov-factor", [&] {
        return finished == std::vector<std::string>{"alpha-beta", "signal", "balsara", "reconstructed"};
    });
    run.fill("sedov-grid-rho", report::number(fine.l1_rho / grid.l1_rho, 2));
    run.fill("sedov-grid-p", report::number(fine.l1_p / grid.l1_p, 2));
    // Times are not asserted where only the text is compared: each is measured once, beside whatever runs.
    run.claim("sedov-grid", [&] {
        const double rho = fine.l1_rho / grid.l1_rho, v = fine.l1_v / grid.l1_v, p = fine.l1_p / grid.l1_p;
        return fine.r.size() == grid.r.size() && 1 < rho && rho < v && v < p &&
               (run.checking() || 20 * grid.seconds < fine.seconds);
    });

    plot::Figure figure{"sedov", 1, 2};
    draw_map(figure.at(0, 0).titled("signal velocity, a quarter"), {fine.x, fine.r, fine.rho}, 0.5, 4, 3.2);
    plot::Panel& profile = figure.at(0, 1).labels("$r$", "ρ").x_range(0, 0.5).y_range(0, 4.2);
    draw_profile(profile, {fine.x, fine.r, fine.rho}, 0.5, signal.styled());
    draw_profile(profile, {grid.x, grid.r, grid.rho}, 0.5, plot::competitor("grid"));
    const exact::Sedov exact{2, scene.gamma, 1, 1};
    plot::draw_exact(profile, 0, 0.5, [&](double r) { return exact.at(r, fine.time).rho; }).style.layer = 2;
    run.save(figure);
}

}  // namespace sph::shocks
