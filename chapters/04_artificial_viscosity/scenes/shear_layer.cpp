#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/finite_volume_2d.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

constexpr double k = 2 * pi;
constexpr int samples = 40;

double amplitude(const Column& y, const Column& v_x, double V) {
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) sum += v_x[i] * std::sin(k * y[i]);
    return 2 * sum / static_cast<double>(y.size()) / V;
}

/// nu of exp(-nu k^2 t), a line through the logarithms of the first `count` amplitudes that begins at 1.
double fitted_viscosity(const ShearRun& run, std::size_t count) {
    double product = 0, squares = 0;
    for (std::size_t s = 0; s < count; ++s) {
        product -= run.t[s] * std::log(run.amplitude[s] / run.amplitude[0]);
        squares += run.t[s] * run.t[s];
    }
    return product / squares / (k * k);
}

void fit(ShearRun& run) {
    run.viscosity = fitted_viscosity(run, run.t.size());
    run.first_viscosity = fitted_viscosity(run, 1 + samples / 10);
}

}  // namespace

ShearRun run_shear(const ShearScene& scene, const Method& method) {
    const double begin = report::thread_cpu_seconds(), V = scene.speed;
    const Placed placed = make_lattice(scene.lattice, {0, 0}, {1, 1}, static_cast<double>(scene.n));
    const std::size_t n = placed.x[0].size();
    const double m = placed.spacing * placed.spacing, u = 1 / (scene.gamma * (scene.gamma - 1));  // c_s = 1
    const Box<2> box{{0, 0}, {1, 1}, Face::periodic};
    const auto gas = make_model(method, n, scene.gamma, box, scene.threads, scene.nu);
    for (std::size_t i = 0; i < n; ++i)
        gas->set(i, {placed.x[0][i], placed.x[1][i]}, {V * std::sin(k * placed.x[1][i]), 0}, m, 1, u);
    gas->resolve(0);
    ShearRun run;
    run.h = method.h_over_dx * placed.spacing;
    const double energy = gas->energy();
    const Vector<2> momentum = gas->momentum();
    double t = 0, size = 0, squares = 0;
    for (const double v : gas->v()[0]) size += m * std::abs(v);
    for (int s = 0; s <= samples; ++s) {
        if (s > 0) gas->advance(t, scene.time * s / samples, scene.courant);
        run.t.push_back(t);
        run.amplitude.push_back(amplitude(gas->x()[1], gas->v()[0], V));
        const Vector<2> change = gas->momentum() - momentum;
        run.momentum_drift = std::max(run.momentum_drift, std::hypot(change[0], change[1]) / size);
        run.energy_drift = std::max(run.energy_drift, std::abs(gas->energy() - energy) / (V * V / 4));
    }
    for (const double v : gas->v()[1]) squares += v * v / static_cast<double>(n);
    run.noise = std::sqrt(squares) / V;
    run.x = gas->x(), run.v_x = gas->v()[0];
    for (std::size_t i = 0; i < n; ++i) {
        Vector<2> x{run.x[0][i], run.x[1][i]};
        box.wrap(x);
        run.x[0][i] = x[0], run.x[1][i] = x[1];
    }
    run.counters = gas->counters();
    run.seconds = report::thread_cpu_seconds() - begin;
    fit(run);
    return run;
}

ShearRun run_shear_grid(const ShearScene& scene) {
    const double begin = report::thread_cpu_seconds(), V = scene.speed;
    exact::GasGrid grid{0, 1, 0, 1, scene.n, scene.n, {}};
    grid.fill([&](double, double y) {
        return exact::GasState2D{1, V * std::sin(k * y), 0, 1 / scene.gamma};
    });
    const auto round = exact::End::periodic;
    exact::FiniteVolume2D solver{grid,
                                 {.gamma = scene.gamma,
                                  .left = round,
                                  .right = round,
                                  .bottom = round,
                                  .top = round,
                                  .viscosity = scene.nu}};
    ShearRun run;
    for (int s = 0; s <= samples; ++s) {
        solver.advance_to(scene.time * s / samples);
        run.t.push_back(solver.time());
        Column y, v_x;
        const exact::GasGrid cells = solver.cells();
        for (std::size_t j = 0; j < scene.n; ++j) {
            y.push_back(cells.y(j));
            v_x.push_back(cells.at(0, j).vx);  // the same in each column
        }
        run.amplitude.push_back(amplitude(y, v_x, V));
    }
    run.counters.steps = solver.steps();
    run.seconds = report::thread_cpu_seconds() - begin;
    fit(run);
    return run;
}

}  // namespace sph
