#include "chapters/04_artificial_viscosity/scenes/sedov_plane.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "common/app/clock.hpp"
#include "common/exact/sedov.hpp"

namespace sph::shocks {
namespace {

constexpr double side = 0.5;

/// The time at which the exact shock is at the scene's radius: R^4 = E t^2/(alpha rho0).
double end_time(const SedovScene& scene) {
    const exact::Sedov blast{2, scene.gamma, 1, 1};
    return std::sqrt(blast.alpha()) * scene.radius * scene.radius;
}

/// The pressure at each of the points: that of the cold gas, and of the blast, whose energy summed over all
/// points of the mass m is `total`.
Column pressures(const SedovScene& scene, const Column& r, double spacing, double total) {
    const IdealGas state{scene.gamma};
    const double width = scene.blast_width * spacing, m = spacing * spacing;
    Column shape;
    double sum = 0;
    for (const double distance : r) {
        shape.push_back(CubicSpline<2>::W(distance, width));
        sum += m * shape.back();
    }
    Column p;
    for (const double W : shape) p.push_back(scene.pressure + state.pressure(1, W * total / sum));
    return p;
}

std::unique_ptr<Simulation<2>> make_blast(const SedovScene& scene, const Method<2>& method) {
    const double begin = scene.quarter ? 0 : -side;
    const Placed placed =
        make_lattice(scene.lattice, {begin, begin}, {side, side}, static_cast<double>(scene.n) / side);
    const std::size_t n = placed.x[0].size();
    auto gas = method.make(
        {.n = n,
         .state = IdealGas{scene.gamma},
         .box = Box<2>{{begin, begin}, {side, side}, scene.quarter ? Face::mirror : Face::periodic},
         .courant = scene.courant,
         .threads = scene.threads});
    const Column p = pressures(scene, radii(placed.x), placed.spacing, scene.quarter ? 0.25 : 1);
    for (std::size_t i = 0; i < n; ++i)
        gas->place(i, {placed.x[0][i], placed.x[1][i]}, {}, placed.spacing * placed.spacing, 1, p[i]);
    gas->start(0);
    gas->resolve(0);
    return gas;
}

/// Errors and the shock's place of what a run has left in r, m, rho, v_r, p.
void measure(SedovRun& run, const SedovScene& scene) {
    const exact::Sedov blast{2, scene.gamma, 1, 1};
    double errors[3] = {}, sums[3] = {};
    for (std::size_t i = 0; i < run.r.size(); ++i) {
        if (run.r[i] >= 0.9 * side) continue;
        const auto exact = blast.at(run.r[i], run.time);
        const double dA = run.m[i] / run.rho[i];
        const double value[3] = {run.rho[i], run.v_r[i], run.p[i]}, at[3] = {exact.rho, exact.v, exact.p};
        for (std::size_t k = 0; k < 3; ++k) {
            errors[k] += dA * std::abs(value[k] - at[k]);
            sums[k] += dA * at[k];
        }
    }
    run.l1_rho = errors[0] / sums[0], run.l1_v = errors[1] / sums[1], run.l1_p = errors[2] / sums[2];
    const Rings rings =
        ring_means(run.r, run.rho, run.m, 0.5 * side / static_cast<double>(scene.n), 0.9 * side);
    const double peak = *std::max_element(rings.value.begin(), rings.value.end()), half = 1 + (peak - 1) / 2;
    run.peak = peak / blast.post_shock(run.time).rho;
    run.shock_radius = outermost_rise(rings, half);
}

}  // namespace

SedovRun run_sedov(const SedovScene& scene, const Method<2>& method) {
    require_lattice(scene.lattice, scene.quarter);
    const auto gas = make_blast(scene, method);
    Drifts drifts{*gas};
    SedovRun run;
    run.time = end_time(scene);
    double t = 0, size = 0;
    run.seconds = march(*gas, t, {.end = run.time, .most_steps = scene.most_steps}).seconds;
    gas->resolve(t);
    drifts.look();
    run.x = gas->get<Position>();
    run.m = gas->get<Mass>(), run.rho = gas->get<Density>(), run.p = gas->get<Pressure>();
    run.r = radii(run.x), run.v_r = radial(run.x, gas->get<Velocity>());
    for (std::size_t i = 0; i < run.m.size(); ++i) size += run.m[i] * std::abs(run.v_r[i]);
    run.energy_drift = drifts.energy() / drifts.first().energy;
    if (!scene.quarter) run.momentum_drift = drifts.momentum() / size;
    run.counters = gas->counters();
    measure(run, scene);
    return run;
}

SedovRun run_sedov_grid(const SedovScene& scene) {
    exact::GasGrid grid{0, side, 0, side, scene.n, scene.n, {}};
    grid.fill([](double, double) { return exact::GasState2D{1, 0, 0, 1}; });
    const Column p = pressures(scene, radii(columns_of(grid).x), grid.dx(), 0.25);
    for (std::size_t i = 0; i < p.size(); ++i) grid.states[i].p = p[i];
    const auto wall = exact::End::reflecting;
    exact::FiniteVolume2D solver{
        grid, {.gamma = scene.gamma, .left = wall, .right = wall, .bottom = wall, .top = wall}};
    SedovRun run;
    run.time = end_time(scene);
    run.seconds = app::thread_cpu_seconds([&] { solver.advance_to(run.time); });
    run.counters.steps = solver.steps();
    const GridColumns columns = columns_of(solver.cells());
    run.x = columns.x, run.m = columns.m, run.rho = columns.rho, run.p = columns.p;
    run.r = radii(run.x), run.v_r = radial(run.x, columns.v);
    measure(run, scene);
    return run;
}

report::Quantities SedovRun::measured() const {
    return {{"l1_rho", l1_rho},
            {"l1_v", l1_v},
            {"l1_p", l1_p},
            {"shock_radius", shock_radius},
            {"peak", peak},
            {"steps", static_cast<double>(counters.steps)},
            {"cpu_seconds", seconds, "s"}};
}

}  // namespace sph::shocks
