#include "chapters/07_godunov_sph/scenes/gresho.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/app/clock.hpp"
#include "common/exact/gresho.hpp"

namespace sph::godunov {
namespace {

constexpr double half = 0.5;

exact::Gresho vortex_of(const GreshoScene& scene) {
    return {1, 0.2, 1, scene.pressure};
}
struct Turning {
    double v_x, v_y, p;
};
Turning turning(const exact::Gresho& vortex, double x, double y) {
    const double r = std::hypot(x, y);
    const auto [v, p] = vortex.at(r);
    return {r > 0 ? -v * y / r : 0, r > 0 ? v * x / r : 0, p};
}

/// Of particles or cells of the masses m and densities rho.
void measure(GreshoRun& run, const exact::Gresho& vortex, const Columns<2>& v, const Column& m,
             const Column& rho) {
    double error = 0, sum = 0, peak = 0, exact_peak = 0, squares = 0, volume = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        const double x = run.x[0][i], y = run.x[1][i], r = std::hypot(x, y), V = m[i] / rho[i];
        const double around = r > 0 ? (x * v[1][i] - y * v[0][i]) / r : 0, exact = vortex.at(r).v;
        const double along = r > 0 ? (x * v[0][i] + y * v[1][i]) / r : 0;
        run.r.push_back(r), run.v.push_back(around);
        if (r < half) error += V * std::abs(around - exact), sum += V * exact;
        if (r > 0.18 && r < 0.22) peak += V * around, exact_peak += V * exact;
        if (r < 0.4) squares += V * square(along), volume += V;
    }
    run.l1_v = error / sum, run.peak = peak / exact_peak, run.noise = std::sqrt(squares / volume);
}
double kinetic_energy(const Columns<2>& v, const Column& m) {
    double sum = 0;
    for (std::size_t i = 0; i < m.size(); ++i) sum += 0.5 * m[i] * (square(v[0][i]) + square(v[1][i]));
    return sum;
}

}  // namespace

GreshoRun run_gresho(const GreshoScene& scene, const shocks::Method<2>& method) {
    const exact::Gresho vortex = vortex_of(scene);
    const shocks::Placed placed =
        make_lattice(scene.lattice, {-half, -half}, {half, half}, static_cast<double>(scene.n));
    const Box<2> box{{-half, -half}, {half, half}, Face::periodic};
    const std::size_t n = placed.x[0].size();
    const auto gas = method.make({.n = n,
                                  .state = IdealGas{scene.gamma},
                                  .box = box,
                                  .courant = scene.courant,
                                  .threads = scene.threads});
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Turning at = turning(vortex, placed.x[0][i], placed.x[1][i]);
        gas->place(i, {placed.x[0][i], placed.x[1][i]}, {at.v_x, at.v_y}, square(placed.spacing), 1, at.p);
        size += square(placed.spacing) * std::hypot(at.v_x, at.v_y);
    }
    gas->start(0);
    gas->resolve(0);
    const double kinetic = kinetic_energy(gas->get<Velocity>(), gas->get<Mass>());
    Drifts drifts{*gas};
    GreshoRun run;
    double t = 0;
    run.seconds = march(*gas, t, {.end = scene.time}).seconds;
    gas->resolve(t);
    drifts.look();
    run.x = gas->get<Position>();
    for (std::size_t i = 0; i < n; ++i) {
        Vector<2> inside{run.x[0][i], run.x[1][i]};
        box.wrap(inside);
        run.x[0][i] = inside[0], run.x[1][i] = inside[1];
    }
    run.kinetic = kinetic_energy(gas->get<Velocity>(), gas->get<Mass>()) / kinetic;
    run.energy_drift = drifts.energy() / drifts.first().energy;
    run.momentum_drift = drifts.momentum() / size;
    run.counters = gas->counters();
    measure(run, vortex, gas->get<Velocity>(), gas->get<Mass>(), gas->get<Density>());
    return run;
}

GreshoRun run_gresho_grid(const GreshoScene& scene) {
    const exact::Gresho vortex = vortex_of(scene);
    exact::GasGrid grid{-half, half, -half, half, scene.n, scene.n, {}};
    grid.fill([&](double x, double y) {
        const Turning at = turning(vortex, x, y);
        return exact::GasState2D{1, at.v_x, at.v_y, at.p};
    });
    const auto round = exact::End::periodic;
    exact::FiniteVolume2D solver{
        grid, {.gamma = scene.gamma, .left = round, .right = round, .bottom = round, .top = round}};
    const auto before = shocks::columns_of(grid);
    GreshoRun run;
    run.seconds = app::thread_cpu_seconds([&] { solver.advance_to(scene.time); });
    run.counters.steps = solver.steps();
    const auto columns = shocks::columns_of(solver.cells());
    run.x = columns.x;
    run.kinetic = kinetic_energy(columns.v, columns.m) / kinetic_energy(before.v, before.m);
    measure(run, vortex, columns.v, columns.m, columns.rho);
    return run;
}

report::Quantities GreshoRun::measured() const {
    return {{"l1_v", l1_v},
            {"peak", peak},
            {"noise", noise},
            {"kinetic", kinetic},
            {"steps", static_cast<double>(counters.steps)},
            {"cpu_seconds", seconds, "s"}};
}

}  // namespace sph::godunov
