#include "chapters/08_landau_model/scenes/grid.hpp"

#include <algorithm>
#include <cmath>

#include "common/app/clock.hpp"
#include "common/exact/relativistic_finite_volume.hpp"

namespace sph::landau {
namespace {

/// s* of both halves at the centres of the cells.
SlabProfile read(const exact::FluidCells& cells, double t) {
    SlabProfile profile;
    profile.time = t;
    const auto add = [&](std::size_t i, double side) {
        const auto& [eps, v] = cells.states[i];
        profile.x.push_back(side * cells.centre(i));
        profile.s_star.push_back(std::pow(eps, 0.75) / std::sqrt((1 - v) * (1 + v)));
        profile.eps.push_back(eps);
        profile.rapidity.push_back(side * std::atanh(v));
    };
    for (std::size_t i = cells.size(); i-- > 0;) add(i, -1);
    for (std::size_t i = 0; i < cells.size(); ++i) add(i, 1);
    profile.l1_s_star = slab_error(profile.x, profile.s_star, t);
    return profile;
}

}  // namespace

std::vector<SlabProfile> run_grid_slab(std::size_t n, const std::vector<double>& times) {
    const double end = static_cast<double>(n) / (static_cast<double>(n) - 4);
    exact::RelativisticFiniteVolume<exact::BaryonFreeFluid> grid{
        exact::half_slab(end, n), {}, {.left = exact::End::reflecting, .courant = 0.5, .expansion = 1 / end}};
    const double energy = grid.energy();
    double seconds = 0;
    std::vector<SlabProfile> profiles;
    for (const double t : times) {
        seconds += app::thread_cpu_seconds([&] { grid.advance_to(t); });
        profiles.push_back(read(grid.cells(), t));
        profiles.back().seconds = seconds;
        profiles.back().energy_drift = grid.energy() / energy - 1;
        profiles.back().counters.steps = grid.steps();
        profiles.back().counters.pairs = grid.cell_updates();
    }
    return profiles;
}

TubeRun run_grid_relativistic_tube(const TubeScene& scene) {
    const auto solution = relativistic_solution(scene);
    const auto& waves = solution.waves();
    const double dx = (scene.window[1] - scene.window[0]) / static_cast<double>(scene.n);
    const double reach =
        std::max({scene.diaphragm - scene.window[0], scene.window[1] - scene.diaphragm,
                  -1.02 * waves.left.head.v * scene.time, 1.02 * waves.right.head.v * scene.time});
    const auto half = static_cast<std::size_t>(std::ceil(reach / dx)) + 4;
    const double length = static_cast<double>(half) * dx;
    exact::RelativisticFiniteVolume<exact::RelativisticGas> grid{
        exact::uniform_tube(scene.diaphragm - length, scene.diaphragm, scene.diaphragm + length, 2 * half,
                            scene.left, scene.right),
        {scene.gamma},
        {}};
    TubeRun run;
    run.seconds = app::thread_cpu_seconds([&] { grid.advance_to(scene.time); });
    run.counters.steps = grid.steps();
    run.counters.pairs = grid.cell_updates();
    const exact::GasCells cells = grid.cells();
    const IdealGas gas{scene.gamma};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [rho, v, p] = cells.states[i];
        run.whole.x.push_back(cells.centre(i)), run.whole.rho.push_back(rho), run.whole.v.push_back(v);
        run.whole.p.push_back(p), run.whole.u.push_back(gas.energy(rho, p));
    }
    shocks::compare(run, Column(run.whole.x.size(), dx), exact_relativistic_tube(scene));
    return run;
}

}  // namespace sph::landau
