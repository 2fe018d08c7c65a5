#include "chapters/04_artificial_viscosity/scenes/viscous_flow.hpp"

#include <cmath>

#include "common/core/unstable.hpp"
#include "common/exact/finite_volume_2d.hpp"
#include "common/exact/taylor_green.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

constexpr int samples = 20;

exact::TaylorGreen solution_of(const VortexScene& scene) {
    return {1 / scene.reynolds, 1, 1, 1};
}
/// rho c_s^2/gamma: the pressure to which that of the vortices is added.
double background(const VortexScene& scene) {
    return 1 / (scene.gamma * scene.mach * scene.mach);
}

double kinetic(const Columns<2>& v) {
    double sum = 0;
    for (std::size_t i = 0; i < v[0].size(); ++i) sum += 0.5 * (v[0][i] * v[0][i] + v[1][i] * v[1][i]);
    return sum / static_cast<double>(v[0].size());
}

/// The decay's rate, a line through the logarithms that begins at the first, and the error at the end.
void measure(VortexRun& run, const VortexScene& scene) {
    const exact::TaylorGreen exact = solution_of(scene);
    double product = 0, squares = 0, errors = 0, sums = 0;
    for (std::size_t s = 0; s < run.t.size(); ++s) {
        product -= run.t[s] * std::log(run.energy[s] / run.energy[0]) / 2;
        squares += run.t[s] * run.t[s];
    }
    run.decay_rate = product / squares;
    run.exact_rate = exact.decay_rate();
    for (std::size_t i = 0; i < run.x[0].size(); ++i) {
        const auto at = exact.at(run.x[0][i], run.x[1][i], run.t.back());
        errors += std::pow(run.v[0][i] - at.v_x, 2) + std::pow(run.v[1][i] - at.v_y, 2);
        sums += at.v_x * at.v_x + at.v_y * at.v_y;
    }
    run.l2_v = std::sqrt(errors / sums);
}

}  // namespace

VortexRun run_vortex(const VortexScene& scene, const Method& method) {
    const double begin = report::thread_cpu_seconds();
    const exact::TaylorGreen exact = solution_of(scene);
    const Placed placed = make_lattice(scene.lattice, {0, 0}, {1, 1}, static_cast<double>(scene.n));
    const std::size_t n = placed.x[0].size();
    const double m = placed.spacing * placed.spacing;
    const auto gas = make_model(method, n, scene.gamma, Box<2>{{0, 0}, {1, 1}, Face::periodic}, scene.threads,
                                1 / scene.reynolds);
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = exact.at(placed.x[0][i], placed.x[1][i], 0);
        const double u = (background(scene) + at.p) / (scene.gamma - 1);
        gas->set(i, {placed.x[0][i], placed.x[1][i]}, {at.v_x, at.v_y}, m, 1, u);
    }
    gas->resolve(0);
    VortexRun run;
    const double energy = gas->energy(), kinetic_energy = kinetic(gas->v());
    double t = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) size += m * std::hypot(gas->v()[0][i], gas->v()[1][i]);
    const Vector<2> momentum = gas->momentum();
    for (int s = 0; s <= samples; ++s) {
        if (s > 0) gas->advance(t, scene.time * s / samples, scene.courant);
        run.t.push_back(t);
        run.energy.push_back(kinetic(gas->v()));
    }
    run.seconds = report::thread_cpu_seconds() - begin;
    run.energy_drift = std::abs(gas->energy() - energy) / kinetic_energy;
    const Vector<2> change = gas->momentum() - momentum;
    run.momentum_drift = std::hypot(change[0], change[1]) / size;
    run.x = gas->x(), run.v = gas->v();
    run.counters = gas->counters();
    measure(run, scene);
    return run;
}

VortexRun run_vortex_grid(const VortexScene& scene) {
    const double begin = report::thread_cpu_seconds();
    const exact::TaylorGreen exact = solution_of(scene);
    exact::GasGrid grid{0, 1, 0, 1, scene.n, scene.n, {}};
    grid.fill([&](double x, double y) {
        const auto at = exact.at(x, y, 0);
        return exact::GasState2D{1, at.v_x, at.v_y, background(scene) + at.p};
    });
    const auto round = exact::End::periodic;
    exact::FiniteVolume2D solver{grid,
                                 {.gamma = scene.gamma,
                                  .left = round,
                                  .right = round,
                                  .bottom = round,
                                  .top = round,
                                  .viscosity = 1 / scene.reynolds}};
    VortexRun run;
    for (int s = 0; s <= samples; ++s) {
        solver.advance_to(scene.time * s / samples);
        run.t.push_back(solver.time());
        run.v = {};
        for (const exact::GasState2D& cell : solver.cells().states)
            run.v[0].push_back(cell.vx), run.v[1].push_back(cell.vy);
        run.energy.push_back(kinetic(run.v));
    }
    run.seconds = report::thread_cpu_seconds() - begin;
    for (std::size_t j = 0; j < scene.n; ++j) {
        for (std::size_t i = 0; i < scene.n; ++i)
            run.x[0].push_back(grid.x(i)), run.x[1].push_back(grid.y(j));
    }
    run.counters.steps = solver.steps();
    measure(run, scene);
    return run;
}

}  // namespace sph
