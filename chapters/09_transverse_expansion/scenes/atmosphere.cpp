#include "chapters/09_transverse_expansion/scenes/atmosphere.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/09_transverse_expansion/curved_line.hpp"
#include "common/app/error.hpp"
#include "common/core/dense.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {
namespace {

using AirKernel = AnyKernel<1>;
constexpr std::size_t wall_particles = 8;  ///< held particles beyond each end, more than a kernel reaches

// [atmosphere]
using AirResolution = ConsistentH<AirKernel, OfCurvedEntropy>;
using Air = CurvedFluid<AirResolution, ConformalFluid, Rindler>;

std::unique_ptr<Air> air_of(const AtmosphereScene& scene, double sign) {
    constexpr double h_over_dx = 1.5, close = 1e-8;
    const std::size_t all = scene.n + 2 * wall_particles;
    auto air = std::make_unique<Air>(all, AirResolution{HRule{h_over_dx}, close, AirKernel{"wendland-c4"}},
                                     ConformalFluid{scene.c2}, Rindler{scene.a, scene.c2, sign}, Free{},
                                     scene.threads);
    const double dx = (scene.top - scene.bottom) / static_cast<double>(scene.n);
    for (std::size_t i = 0; i < all; ++i) {
        const double x = scene.bottom + (static_cast<double>(i) - wall_particles + 0.5) * dx;
        air->particles.x[0][i] = x;
        air->particles.s_star[i] = std::pow(x, -1 / scene.c2);  // at rest s* = s = T^(1/c2)
        air->particles.nu[i] = air->particles.s_star[i] * dx;
    }
    air->particles.groups.hold("bottom", 0, wall_particles);
    air->particles.groups.hold("top", wall_particles + scene.n, all);
    air->start(0);
    air->template integrate_by<RungeKutta4>();
    air->limit_steps(
        [&one = *air, courant = scene.courant] { return courant * one.crossing_time(one.resolved_at()); });
    return air;
}
// [end]

/// dq/dt of the free particles at places x, from rest.
Column air_forces(Air& air, const Column& x) {
    std::copy(x.begin(), x.end(), air.particles.x[0].begin() + wall_particles);
    air.rates(0);
    const auto first = air.particles.dq_dt[0].begin() + wall_particles;
    return Column(first, first + static_cast<std::ptrdiff_t>(x.size()));
}

double largest(const Column& values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

/// d force/dx by differences over 2 shift.
Dense air_slopes(Air& air, Column x, double shift) {
    Dense slopes{x.size()};
    for (std::size_t j = 0; j < x.size(); ++j) {
        const double place = x[j];
        x[j] = place + shift;
        const Column after = air_forces(air, x);
        x[j] = place - shift;
        const Column before = air_forces(air, x);
        x[j] = place;
        for (std::size_t i = 0; i < x.size(); ++i) slopes(i, j) = (after[i] - before[i]) / (2 * shift);
    }
    return slopes;
}

/// Moves the free particles to where there is no force, by Newton's method; returns the largest one left.
double settle_air(Air& air, std::size_t n, double dx) {
    constexpr int most_steps = 30;
    constexpr double none = 1e-13, longest_step = 0.2, small = 1e-6;  // steps in spacings
    const auto first = air.particles.x[0].begin() + wall_particles;
    Column x(first, first + static_cast<std::ptrdiff_t>(n)), force = air_forces(air, x);
    for (int k = 0; k < most_steps && largest(force) > none; ++k) {
        const Column step = solve(air_slopes(air, x, 1e-4 * dx), force);
        const double part = std::min(1.0, longest_step * dx / largest(step));
        Column next = x;
        for (std::size_t i = 0; i < n; ++i) next[i] -= part * step[i];
        const Column left = air_forces(air, next);
        if (largest(step) < small * dx && largest(left) >= largest(force)) break;  // rounding
        x = next, force = left;
    }
    return largest(air_forces(air, x));
}

}  // namespace

double AtmosphereScene::crossing_time() const {
    return std::log(top / bottom) / (a * std::sqrt(c2));
}

Atmosphere run_atmosphere(const AtmosphereScene& scene) {
    if (scene.n < 10) throw std::invalid_argument{"fewer than ten particles"};
    const double height = scene.top - scene.bottom, dx = height / static_cast<double>(scene.n);
    Atmosphere found;
    const auto settled = air_of(scene, -1);
    found.settled = settle_air(*settled, scene.n, dx);
    const auto air = air_of(scene, scene.sign);
    air->particles.x = settled->particles.x;
    air->particles.s_star = settled->particles.s_star;
    air->particles.h = settled->particles.h;
    const auto& x = air->particles.x[0];
    const Column start = x;
    double t = 0;
    for (int k = 1; k <= scene.samples; ++k) {
        const double share = scene.crossings * k / scene.samples;
        found.seconds += march(*air, t, {.end = share * scene.crossing_time()}, [&](double now) {
                             require_order(x, now);
                         }).seconds;
        double moved = 0;
        for (std::size_t i = wall_particles; i < wall_particles + scene.n; ++i)
            moved = std::max(moved, std::abs(x[i] - start[i]));
        found.times.push_back(share);
        found.moved.push_back(moved / height);
    }
    air->resolve(t);
    double difference = 0, whole = 0;
    for (std::size_t i = wall_particles; i < wall_particles + scene.n; ++i) {
        const double T = std::pow(air->entropy(i, t), scene.c2), exact = 1 / x[i];
        found.x.push_back(x[i]);
        found.temperature.push_back(T);
        found.exact_temperature.push_back(exact);
        found.v.push_back(air->particles.v[0][i]);
        found.speed =
            std::max(found.speed, std::abs(found.v.back()) / (scene.a * x[i] * std::sqrt(scene.c2)));
        found.mean_shift += (x[i] - start[i]) / (height * static_cast<double>(scene.n));
        difference += std::abs(T - exact), whole += exact;
    }
    found.l1_temperature = difference / whole;
    found.counters = air->counters();
    return found;
}

void AtmosphereCommand::declare(app::CommandLine& line) {
    line.integer("particles", particles_, 10, 2000, "between the walls at x = 1 and x = 2")
        .number("time", time_, {0, 1000, true}, "crossings", "in times of sound from wall to wall")
        .number("sound-speed-squared", c2_, {0.05, 0.9}, "c^2", "c0^2 of P = c0^2 eps")
        .number("courant", courant_, {0, 1, true}, "",
                "step over the shortest time in which sound crosses an h")
        .flag("printed", printed_, "the last line of (322) with the sign that is printed");
}

void AtmosphereCommand::run(report::Run& run) const {
    const AtmosphereScene scene{.n = static_cast<std::size_t>(particles_),
                                .c2 = c2_,
                                .sign = printed_ ? 1.0 : -1.0,
                                .crossings = time_,
                                .courant = courant_,
                                .threads = run.threads()};
    const Atmosphere air = run_atmosphere(scene);
    run.record(printed_ ? "printed" : "corrected", scene.n,
               {{"l1_temperature", air.l1_temperature},
                {"moved", air.moved.back(), "height"},
                {"mean_shift", air.mean_shift, "height"},
                {"speed", air.speed, "sound speed"},
                {"steps", static_cast<double>(air.counters.steps)},
                {"cpu_seconds", air.seconds, "s"}});
    run.write("profile.csv", report::csv({{"x", air.x},
                                          {"temperature", air.temperature},
                                          {"exact_temperature", air.exact_temperature},
                                          {"v", air.v}}));
    plot::Figure figure{"atmosphere-scene"};
    plot::beside_exact(figure.panel().labels("$x$", "$T$"), air.x, air.exact_temperature, air.x,
                       air.temperature);
    run.save(figure);
}

}  // namespace sph::transverse
