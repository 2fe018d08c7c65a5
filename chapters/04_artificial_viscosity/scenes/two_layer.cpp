#include "chapters/04_artificial_viscosity/scenes/two_layer.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "chapters/04_artificial_viscosity/physical_viscosity.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "common/report/norms.hpp"

namespace sph::shocks {
namespace {

constexpr std::size_t beyond = 6;    ///< rows of held particles beyond a wall; the reach is 5.2 spacings
constexpr std::size_t thinnest = 8;  ///< rows of a layer: some must not see the other one

void require_rows(const LayersScene& scene) {
    const double lower = scene.interface * static_cast<double>(scene.n);
    if (std::abs(lower - std::round(lower)) > 1e-9)
        throw std::invalid_argument{"the interface does not lie between two rows"};
    if (std::min(lower, static_cast<double>(scene.n) - lower) < thinnest)
        throw std::invalid_argument{"a layer has fewer than eight rows"};
}

double wall_velocity(const LayersScene& scene, const exact::TwoLayer& exact, double y) {
    if (scene.walls == Walls::rigid) return y < 0 ? 0 : 1;
    const double tau = exact.at(0).tau, mu = scene.viscosity;
    return y < 0 ? tau * y / mu : 1 + tau * (y - 1) / (mu * scene.ratio);
}

/// Free rows first, from below, then those beyond the lower and beyond the upper wall. Behind them lie
/// mirrors, so that they have neighbours on all sides.
std::unique_ptr<Simulation<2>> make_layers(const LayersScene& scene, const Method<2>& method) {
    const double dx = 1 / static_cast<double>(scene.n), depth = beyond * dx;
    const std::size_t free = scene.columns * scene.n, held = scene.columns * beyond;
    const Box<2> box{{0, -depth},
                     {static_cast<double>(scene.columns) * dx, 1 + depth},
                     {std::pair{Face::periodic, Face::periodic}, std::pair{Face::mirror, Face::mirror}}};
    auto gas = method.make({.n = free + 2 * held,
                            .state = IdealGas{scene.gamma},
                            .box = box,
                            .courant = scene.courant,
                            .threads = scene.threads});
    const double p = 1 / (scene.gamma * scene.mach * scene.mach);
    std::mt19937_64 random{1};
    std::size_t i = 0;
    const auto lay = [&](double low, std::size_t rows, double jitter, const auto& velocity) {
        const auto place = [&](double low_end, std::size_t k) {
            return low_end + (static_cast<double>(k) + 0.5 + jitter * random_shift(random)) * dx;
        };
        for (std::size_t row = 0; row < rows; ++row) {
            const bool below = low + (static_cast<double>(row) + 0.5) * dx < scene.interface;
            for (std::size_t column = 0; column < scene.columns; ++column, ++i) {
                const double x = place(0, column), y = place(low, row);
                gas->place(i, {x, y}, {velocity(y), 0}, square(dx), 1, p);
                gas->get<DynamicViscosity>()[i] = scene.viscosity * (below ? 1 : scene.ratio);
            }
        }
    };
    const exact::TwoLayer exact = scene.solution();
    const auto of_wall = [&](double y) { return wall_velocity(scene, exact, y); };
    lay(0, scene.n, scene.jitter, [](double y) { return y; });
    lay(-depth, beyond, 0, of_wall);
    lay(1, beyond, 0, of_wall);
    gas->groups().hold("lower wall", free, free + held);
    gas->groups().hold("upper wall", free + held, free + 2 * held);
    gas->start(0);
    gas->resolve(0);
    return gas;
}

Column first(const Column& column, std::size_t count) {
    return {column.begin(), column.begin() + static_cast<std::ptrdiff_t>(count)};
}
double mean_change(const Column& before, const Column& v) {
    double change = 0, size = 0;
    for (std::size_t i = 0; i < v.size(); ++i) change += std::abs(v[i] - before[i]), size += std::abs(v[i]);
    return change / size;
}

struct Line {
    double slope, at_interface;
};
/// By least squares through the particles with low < y < high.
Line line_through(const LayersRun& run, double low, double high, double interface) {
    double n = 0, y = 0, v = 0, yy = 0, yv = 0;
    for (std::size_t i = 0; i < run.y.size(); ++i) {
        if (!(run.y[i] > low && run.y[i] < high)) continue;
        const double from = run.y[i] - interface;
        n += 1, y += from, v += run.v[i], yy += from * from, yv += from * run.v[i];
    }
    const double slope = (n * yv - y * v) / (n * yy - y * y);
    return {slope, (v - slope * y) / n};
}

void measure(LayersRun& run, const LayersScene& scene, double reach) {
    const exact::TwoLayer exact = scene.solution();
    Column expected;
    for (const double y : run.y) expected.push_back(exact.at(std::clamp(y, 0.0, 1.0)).v);
    run.l1_v = report::l1_error(run.v, expected);
    const double s = scene.interface, tau = exact.at(0).tau;
    const Line lower = line_through(run, 0, s - reach, s), upper = line_through(run, s + reach, 1, s);
    run.slip = upper.at_interface - lower.at_interface;
    run.lower_stress = scene.viscosity * lower.slope / tau - 1;
    run.upper_stress = scene.viscosity * scene.ratio * upper.slope / tau - 1;
}

}  // namespace

double LayersScene::time() const {
    // The less viscous layer is held on both sides, the other one, which drags it along, by its wall alone.
    const double lower = square(ratio < 1 ? 2 * interface : interface) / viscosity;
    const double upper = square(ratio < 1 ? 1 - interface : 2 * (1 - interface)) / (viscosity * ratio);
    return fadings * std::max(lower, upper) / square(pi);
}

exact::TwoLayer LayersScene::solution() const {
    return exact::TwoLayer{
        {.lower_viscosity = viscosity, .upper_viscosity = viscosity * ratio, .interface = interface}};
}

LayersRun run_layers(const LayersScene& scene, const Method<2>& method) {
    require_rows(scene);
    const auto gas = make_layers(scene, method);
    const std::size_t free = scene.columns * scene.n;
    const Column& v = gas->get<Velocity>()[0];
    LayersRun run;
    Drifts drifts{*gas};
    double t = 0;
    for (const double share : {0.9, 1.0}) {
        const Column before = v;
        run.seconds += march(*gas, t, {.end = share * scene.time()}).seconds;
        gas->resolve(t);
        drifts.look();
        run.unsteady = mean_change(first(before, free), first(v, free));
    }
    run.y = first(gas->get<Position>()[1], free), run.v = first(v, free);
    run.counters = gas->counters();
    run.energy_drift = drifts.energy() / (drifts.first().mass / 2);
    run.momentum_drift =
        std::abs(gas->totals().momentum[0] - drifts.first().momentum[0]) / drifts.first().mass;
    measure(run, scene, 2 * method.h_over_dx / static_cast<double>(scene.n));
    return run;
}

report::Quantities LayersRun::measured() const {
    return {{"l1_v", l1_v},
            {"slip", slip},
            {"lower_stress", lower_stress},
            {"upper_stress", upper_stress},
            {"unsteady", unsteady},
            {"energy_drift", energy_drift},
            {"momentum_drift", momentum_drift}};
}

}  // namespace sph::shocks
