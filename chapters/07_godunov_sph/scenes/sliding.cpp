#include "chapters/07_godunov_sph/scenes/sliding.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "common/app/clock.hpp"

namespace sph::godunov {
namespace {

using exact::ShearInstability;
constexpr int looks = 20;  // at the amplitude, in the time

ShearInstability::State disturbed(const ShearInstability& theory, double amplitude, double x, double y) {
    const auto base = theory.base(y), more = theory.disturbance(x, y);
    return {base.rho + amplitude * more.rho, base.v_x + amplitude * more.v_x, amplitude * more.v_y,
            base.p + amplitude * more.p};
}

/// What the velocities v_y at those places have of the mode.
double part_of_mode(const ShearInstability& theory, const Columns<2>& x, const Column& v_y, const Column& m,
                    const Column& rho) {
    std::complex<double> product{};
    double squares = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        const double V = m[i] / rho[i];
        const auto mode = theory.mode(x[1][i]) * std::polar(1.0, 2 * pi * x[0][i]);
        product += V * v_y[i] * std::conj(mode), squares += V * std::norm(mode);
    }
    return 2 * std::abs(product) / squares;
}

void fit(SlidingRun& run, double theory) {
    run.theory = theory;
    double n = 0, t = 0, a = 0, tt = 0, ta = 0;
    const double first = run.amplitude[0];
    for (double& amplitude : run.amplitude) amplitude /= first;
    for (std::size_t k = run.t.size() / 2; k < run.t.size(); ++k) {
        const double l = std::log(run.amplitude[k]);
        n += 1, t += run.t[k], a += l, tt += run.t[k] * run.t[k], ta += run.t[k] * l;
    }
    run.growth = (n * ta - t * a) / (n * tt - t * t);
}

}  // namespace

SlidingRun run_sliding(const SlidingScene& scene, const shocks::Method<2>& method) {
    const ShearInstability theory{scene.flow};
    const Box<2> box{{0, 0}, {1, 1}, Face::periodic};
    const shocks::Placed placed =
        make_lattice(shocks::Lattice::square, {0, 0}, {1, 1}, static_cast<double>(scene.n));
    const std::size_t n = placed.x[0].size();
    const auto gas = method.make({.n = n,
                                  .state = IdealGas{scene.flow.gamma},
                                  .box = box,
                                  .courant = scene.courant,
                                  .threads = scene.threads});
    for (std::size_t i = 0; i < n; ++i) {
        const double x = placed.x[0][i], y = placed.x[1][i];
        const auto at = disturbed(theory, scene.amplitude, x, y);
        gas->place(i, {x, y}, {at.v_x, at.v_y}, at.rho * square(placed.spacing), at.rho, at.p);
    }
    gas->start(0);
    gas->resolve(0);
    Drifts drifts{*gas};
    SlidingRun run;
    double t = 0;
    for (int k = 0; k <= looks; ++k) {
        if (k > 0) run.seconds += march(*gas, t, {.end = scene.time * k / looks}).seconds;
        gas->resolve(t);
        drifts.look();
        run.t.push_back(t);
        run.amplitude.push_back(part_of_mode(theory, gas->get<Position>(), gas->get<Velocity>()[1],
                                             gas->get<Mass>(), gas->get<Density>()));
    }
    run.x = gas->get<Position>(), run.rho = gas->get<Density>();
    for (std::size_t i = 0; i < n; ++i) {
        Vector<2> inside{run.x[0][i], run.x[1][i]};
        box.wrap(inside);
        run.x[0][i] = inside[0], run.x[1][i] = inside[1];
    }
    run.energy_drift = drifts.energy() / drifts.first().energy;
    run.counters = gas->counters();
    fit(run, theory.growth());
    return run;
}

SlidingRun run_sliding_grid(const SlidingScene& scene) {
    const ShearInstability theory{scene.flow};
    exact::GasGrid grid{0, 1, 0, 1, scene.n, scene.n, {}};
    grid.fill([&](double x, double y) {
        const auto at = disturbed(theory, scene.amplitude, x, y);
        return exact::GasState2D{at.rho, at.v_x, at.v_y, at.p};
    });
    const auto round = exact::End::periodic;
    exact::FiniteVolume2D solver{
        grid, {.gamma = scene.flow.gamma, .left = round, .right = round, .bottom = round, .top = round}};
    SlidingRun run;
    for (int k = 0; k <= looks; ++k) {
        run.seconds += app::thread_cpu_seconds([&] { solver.advance_to(scene.time * k / looks); });
        const auto cells = shocks::columns_of(solver.cells());
        run.t.push_back(solver.time());
        run.amplitude.push_back(part_of_mode(theory, cells.x, cells.v[1], cells.m, cells.rho));
        run.x = cells.x, run.rho = cells.rho;
    }
    run.counters.steps = solver.steps();
    fit(run, theory.growth());
    return run;
}

report::Quantities SlidingRun::measured() const {
    return {{"growth", growth / theory, "theory"},
            {"amplitude", amplitude.back()},
            {"steps", static_cast<double>(counters.steps)},
            {"cpu_seconds", seconds, "s"}};
}

}  // namespace sph::godunov
