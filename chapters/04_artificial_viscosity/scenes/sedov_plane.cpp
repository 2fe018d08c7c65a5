#include "chapters/04_artificial_viscosity/scenes/sedov_plane.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/finite_volume_2d.hpp"
#include "common/exact/sedov.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

constexpr double side = 0.5;

/// The time at which the exact shock is at the scene's radius: R^4 = E t^2/(alpha rho0).
double end_time(const SedovScene& scene) {
    const exact::Sedov blast{2, scene.gamma, 1, 1};
    return std::sqrt(blast.alpha()) * scene.radius * scene.radius;
}

/// The energy by mass at each of the points: that of the cold gas, and the blast's, whose sum over all points
/// with the mass m is `total`.
Column energies(const SedovScene& scene, const Column& r, double spacing, double total) {
    const double width = scene.blast_width * spacing, m = spacing * spacing;
    Column u;
    double sum = 0;
    for (const double distance : r) {
        u.push_back(CubicSpline<2>::W(distance, width));
        sum += m * u.back();
    }
    for (double& value : u) value = value * total / sum + scene.pressure / (scene.gamma - 1);
    return u;
}

std::unique_ptr<Model<2>> make_blast(const SedovScene& scene, const Method& method) {
    const double begin = scene.quarter ? 0 : -side;
    const Placed placed =
        make_lattice(scene.lattice, {begin, begin}, {side, side}, static_cast<double>(scene.n) / side);
    const std::size_t n = placed.x[0].size();
    const Box<2> box{{begin, begin}, {side, side}, scene.quarter ? Face::mirror : Face::periodic};
    auto gas = make_model(method, n, scene.gamma, box, scene.threads);
    const Column u = energies(scene, radii(placed.x), placed.spacing, scene.quarter ? 0.25 : 1);
    for (std::size_t i = 0; i < n; ++i)
        gas->set(i, {placed.x[0][i], placed.x[1][i]}, {}, placed.spacing * placed.spacing, 1, u[i]);
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
    for (std::size_t k = rings.r.size(); k-- > 1;) {
        if (rings.value[k - 1] < half) continue;
        const double part = (rings.value[k - 1] - half) / (rings.value[k - 1] - rings.value[k]);
        run.shock_radius = rings.r[k - 1] + part * (rings.r[k] - rings.r[k - 1]);
        return;
    }
}

}  // namespace

SedovRun run_sedov(const SedovScene& scene, const Method& method) {
    if (scene.quarter && scene.lattice != Lattice::square)
        throw std::invalid_argument{"only the square lattice is its own mirror image"};
    const double begin = report::thread_cpu_seconds();
    const auto gas = make_blast(scene, method);
    gas->resolve(0);
    const double energy = gas->energy();
    SedovRun run;
    run.time = end_time(scene);
    double t = 0, size = 0;
    gas->advance(t, run.time, scene.courant,
                 [&](double now) { require_fewer_steps(*gas, scene.most_steps, now); });
    run.seconds = report::thread_cpu_seconds() - begin;
    run.x = gas->x(), run.m = gas->m(), run.rho = gas->rho(), run.p = gas->p();
    run.r = radii(run.x), run.v_r = radial(run.x, gas->v());
    for (std::size_t i = 0; i < run.m.size(); ++i) size += run.m[i] * std::abs(run.v_r[i]);
    run.energy_drift = std::abs(gas->energy() / energy - 1);
    if (!scene.quarter) {
        for (const double component : gas->momentum())
            run.momentum_drift = std::max(run.momentum_drift, std::abs(component) / size);
    }
    run.counters = gas->counters();
    measure(run, scene);
    return run;
}

SedovRun run_sedov_grid(const SedovScene& scene) {
    const double begin = report::thread_cpu_seconds();
    exact::GasGrid grid{0, side, 0, side, scene.n, scene.n, {}};
    grid.fill([](double, double) { return exact::GasState2D{1, 0, 0, 1}; });
    Columns<2> x;
    for (std::size_t j = 0; j < scene.n; ++j) {
        for (std::size_t i = 0; i < scene.n; ++i) x[0].push_back(grid.x(i)), x[1].push_back(grid.y(j));
    }
    const Column u = energies(scene, radii(x), grid.dx(), 0.25);
    for (std::size_t i = 0; i < u.size(); ++i) grid.states[i].p = (scene.gamma - 1) * u[i];
    const auto wall = exact::End::reflecting;
    exact::FiniteVolume2D solver{
        grid, {.gamma = scene.gamma, .left = wall, .right = wall, .bottom = wall, .top = wall}};
    SedovRun run;
    run.time = end_time(scene);
    solver.advance_to(run.time);
    run.seconds = report::thread_cpu_seconds() - begin;
    Columns<2> v;
    for (const exact::GasState2D& cell : solver.cells().states) {
        run.rho.push_back(cell.rho), run.p.push_back(cell.p);
        run.m.push_back(cell.rho * grid.dx() * grid.dy());
        v[0].push_back(cell.vx), v[1].push_back(cell.vy);
    }
    run.x = x;
    run.r = radii(x), run.v_r = radial(x, v);
    run.counters.steps = solver.steps();
    measure(run, scene);
    return run;
}

}  // namespace sph
