#include "chapters/04_artificial_viscosity/scenes/viscous_flow.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "common/app/clock.hpp"
#include "common/exact/taylor_green.hpp"
#include "common/report/norms.hpp"

namespace sph::shocks {
namespace {

constexpr int samples = 20;

exact::TaylorGreen solution_of(const VortexScene& scene) {
    return {1 / scene.reynolds, 1, 1, 1};
}
/// rho c_s^2/gamma: the pressure to which that of the vortices is added.
double background(const VortexScene& scene) {
    return 1 / (scene.gamma * scene.mach * scene.mach);
}

/// Mean by mass.
double kinetic_energy(const Columns<2>& v) {
    double sum = 0;
    for (std::size_t i = 0; i < v[0].size(); ++i) sum += 0.5 * (v[0][i] * v[0][i] + v[1][i] * v[1][i]);
    return sum / static_cast<double>(v[0].size());
}

/// The decay's rate, a line through the logarithms that begins at the first, and the error at the end.
void measure(VortexRun& run, const VortexScene& scene) {
    const exact::TaylorGreen exact = solution_of(scene);
    double product = 0, squares = 0;
    for (std::size_t s = 0; s < run.t.size(); ++s) {
        product -= run.t[s] * std::log(run.energy[s] / run.energy[0]) / 2;
        squares += run.t[s] * run.t[s];
    }
    run.decay_rate = product / squares;
    run.exact_rate = exact.decay_rate();
    report::SquaredError error;
    for (std::size_t i = 0; i < run.x[0].size(); ++i) {
        const auto at = exact.at(run.x[0][i], run.x[1][i], run.t.back());
        error.add(run.v[0][i], at.v_x);
        error.add(run.v[1][i], at.v_y);
    }
    run.l2_v = error.relative();
}

std::unique_ptr<Simulation<2>> make_vortices(const VortexScene& scene, const Method<2>& method) {
    const exact::TaylorGreen exact = solution_of(scene);
    const Placed placed = make_lattice(scene.lattice, {0, 0}, {1, 1}, static_cast<double>(scene.n));
    const std::size_t n = placed.x[0].size();
    auto gas = with_viscosity(method, 1 / scene.reynolds)
                   .make({.n = n,
                          .state = IdealGas{scene.gamma},
                          .box = Box<2>{{0, 0}, {1, 1}, Face::periodic},
                          .courant = scene.courant,
                          .threads = scene.threads});
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = exact.at(placed.x[0][i], placed.x[1][i], 0);
        gas->place(i, {placed.x[0][i], placed.x[1][i]}, {at.v_x, at.v_y}, square(placed.spacing), 1,
                   background(scene) + at.p);
    }
    gas->start(0);
    gas->resolve(0);
    return gas;
}

}  // namespace

VortexRun run_vortex(const VortexScene& scene, const Method<2>& method) {
    const auto gas = make_vortices(scene, method);
    const Columns<2>& v = gas->get<Velocity>();
    VortexRun run;
    Drifts drifts{*gas};
    double t = 0, size = 0;
    for (std::size_t i = 0; i < v[0].size(); ++i) size += gas->get<Mass>()[i] * std::hypot(v[0][i], v[1][i]);
    for (int s = 0; s <= samples; ++s) {
        if (s > 0) {
            run.seconds += march(*gas, t, {.end = scene.time * s / samples}).seconds;
            gas->resolve(t);
        }
        run.t.push_back(t);
        run.energy.push_back(kinetic_energy(v));
    }
    drifts.look();
    run.energy_drift = drifts.energy() / run.energy[0];
    run.momentum_drift = drifts.momentum() / size;
    run.x = gas->get<Position>(), run.v = v;
    run.counters = gas->counters();
    measure(run, scene);
    return run;
}

VortexRun run_vortex_grid(const VortexScene& scene) {
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
        run.seconds += app::thread_cpu_seconds([&] { solver.advance_to(scene.time * s / samples); });
        run.t.push_back(solver.time());
        run.v = columns_of(solver.cells()).v;
        run.energy.push_back(kinetic_energy(run.v));
    }
    run.x = columns_of(grid).x;
    run.counters.steps = solver.steps();
    measure(run, scene);
    return run;
}

}  // namespace sph::shocks
