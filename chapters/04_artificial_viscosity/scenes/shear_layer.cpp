#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/app/clock.hpp"

namespace sph::shocks {
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

Box<2> box() {
    return {{0, 0}, {1, 1}, Face::periodic};
}

std::unique_ptr<Simulation<2>> make_wave(const ShearScene& scene, const Method<2>& method,
                                         const Placed& placed) {
    const std::size_t n = placed.x[0].size();
    auto gas = with_viscosity(method, scene.nu)
                   .make({.n = n,
                          .state = IdealGas{scene.gamma},
                          .box = box(),
                          .courant = scene.courant,
                          .threads = scene.threads});
    for (std::size_t i = 0; i < n; ++i)
        gas->place(i, {placed.x[0][i], placed.x[1][i]}, {scene.speed * std::sin(k * placed.x[1][i]), 0},
                   square(placed.spacing), 1, 1 / scene.gamma);  // c_s = 1
    gas->start(0);
    gas->resolve(0);
    return gas;
}

}  // namespace

Method<2> with_viscosity(Method<2> method, double nu) {
    if (method.parameters.has("nu")) method.parameters.set("nu", nu);
    return method;
}

ShearRun run_shear(const ShearScene& scene, const Method<2>& method) {
    const double V = scene.speed;
    const Placed placed = make_lattice(scene.lattice, {0, 0}, {1, 1}, static_cast<double>(scene.n));
    const auto gas = make_wave(scene, method, placed);
    const Columns<2>&x = gas->get<Position>(), &v = gas->get<Velocity>();
    ShearRun run;
    run.h = method.h_over_dx * placed.spacing;
    Drifts drifts{*gas};
    double t = 0, size = 0, squares = 0;
    for (const double v_x : v[0]) size += square(placed.spacing) * std::abs(v_x);
    for (int s = 0; s <= samples; ++s) {
        if (s > 0) {
            run.seconds += march(*gas, t, {.end = scene.time * s / samples}).seconds;
            gas->resolve(t);
        }
        run.t.push_back(t);
        run.amplitude.push_back(amplitude(x[1], v[0], V));
        drifts.look();
    }
    run.momentum_drift = drifts.momentum() / size;
    run.energy_drift = drifts.energy() / (V * V / 4);
    for (const double v_y : v[1]) squares += v_y * v_y / static_cast<double>(v[1].size());
    run.noise = std::sqrt(squares) / V;
    run.x = x, run.v_x = v[0];
    for (std::size_t i = 0; i < run.v_x.size(); ++i) {
        Vector<2> inside{x[0][i], x[1][i]};
        box().wrap(inside);
        run.x[0][i] = inside[0], run.x[1][i] = inside[1];
    }
    run.counters = gas->counters();
    fit(run);
    return run;
}

ShearRun run_shear_grid(const ShearScene& scene) {
    const double V = scene.speed;
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
    run.h = grid.dx();
    for (int s = 0; s <= samples; ++s) {
        run.seconds += app::thread_cpu_seconds([&] { solver.advance_to(scene.time * s / samples); });
        run.t.push_back(solver.time());
        const GridColumns columns = columns_of(solver.cells());
        run.amplitude.push_back(amplitude(columns.x[1], columns.v[0], V));
    }
    run.counters.steps = solver.steps();
    fit(run);
    return run;
}

report::Quantities ShearRun::measured() const {
    return {{"viscosity", viscosity / h, "c_s h"},
            {"first_viscosity", first_viscosity / h, "c_s h"},
            {"noise", noise, "V"},
            {"momentum_drift", momentum_drift},
            {"energy_drift", energy_drift},
            {"cpu_seconds", seconds, "s"}};
}

}  // namespace sph::shocks
