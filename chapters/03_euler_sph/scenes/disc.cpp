#include "chapters/03_euler_sph/scenes/disc.hpp"

namespace sph::euler {
namespace {

using K = AnyKernel<2>;
const K cubic{"cubic"};
// [type]
using DiscGas = Gas<ConsistentH<K>, Barotropic<Quadratic>, Free, LinearForce, Damping>;
// [end]
using DiscParticles = DiscGas::P;

double radius2(const Columns<2>& x, std::size_t i) {
    return square(x[0][i]) + square(x[1][i]);
}

/// Points of the unit disc and their masses; the mass of all is pi/2.
void place(const DiscScene& scene, Columns<2>& x, Column& m) {
    if (scene.start == DiscStart::random_equal) {
        Uniform uniform{scene.seed};
        while (x[0].size() < scene.n) {
            const double a = 2 * uniform() - 1, b = 2 * uniform() - 1;
            if (a * a + b * b >= 1) continue;
            x[0].push_back(a);
            x[1].push_back(b);
        }
        m.assign(scene.n, pi / 2 / static_cast<double>(scene.n));
        return;
    }
    const double cell = std::sqrt(pi / static_cast<double>(scene.n));
    const auto half = static_cast<int>(1 / cell) + 1;
    for (int a = -half; a <= half; ++a) {
        for (int b = -half; b <= half; ++b) {
            const double X = cell * (a + 0.5), Y = cell * (b + 0.5);
            if (X * X + Y * Y >= square(1 - 0.5 * cell)) continue;  // so that no mass vanishes
            x[0].push_back(X);
            x[1].push_back(Y);
            m.push_back((1 - X * X - Y * Y) * cell * cell);
        }
    }
}

/// The mean distance to the nearest other particle, in spacings sqrt(m/rho). Cost: all pairs.
double mean_nearest(const DiscParticles& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < p.size(); ++j) {
            if (j != i) nearest = std::min(nearest, std::hypot(p.x[0][i] - p.x[0][j], p.x[1][i] - p.x[1][j]));
        }
        sum += nearest / std::sqrt(p.m[i] / p.rho[i]);
    }
    return sum / static_cast<double>(p.size());
}

struct Interpolated {
    Column function, gradient;
    double function_error = 0, gradient_error = 0;
};

/// Chapter 1's estimates on these particles, with the volumes m/rho and each particle's h.
Interpolated interpolate(const DiscParticles& p, const Columns<2>& x) {
    using Points =
        ParticlesOf<2, List<Position, SmoothingLength, Volume, Quantity, Value, DifferenceGradient>>;
    Points points{p.size()};
    points.x = x;
    points.h = p.h;
    Column reach;
    for (std::size_t i = 0; i < p.size(); ++i) {
        points.V[i] = p.m[i] / p.rho[i];
        reach.push_back(cubic.support * p.h[i]);
    }
    Neighbours<2> neighbours;
    neighbours.find(points.x, reach);
    Interpolated result;
    const auto exact = [&](std::size_t i) { return radius2(x, i) * std::exp(-6 * radius2(x, i)); };
    for (std::size_t i = 0; i < p.size(); ++i) points.A[i] = exact(i);
    sum_over_neighbours(points, neighbours, OwnH<K>{cubic}, Effects{Value{}});
    const double largest = std::exp(-1.0) / 6;
    for (std::size_t i = 0; i < p.size(); ++i)
        result.function_error =
            std::max(result.function_error, std::abs(points.value[i] - exact(i)) / largest);
    result.function = points.value;
    for (std::size_t i = 0; i < p.size(); ++i) points.A[i] = radius2(x, i) - 1;
    sum_over_neighbours(points, neighbours, OwnH<K>{cubic}, Effects{DifferenceGradient{}});
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (radius2(x, i) >= square(0.9)) continue;
        sum += square(points.gradient[0][i] - 2 * x[0][i]);
        count += 1;
    }
    result.gradient_error = std::sqrt(sum / count);
    result.gradient = points.gradient[0];
    return result;
}

}  // namespace

DiscRun run_disc(const DiscScene& scene) {
    const Quadratic state{0.25};
    DiscRun run;
    Column m;
    place(scene, run.start_x, m);
    const std::size_t n = m.size();
    DiscGas gas{n,
                ConsistentH<K>{HRule{scene.h_over_dx}, 1e-12, cubic},
                {state},
                Free{},
                scene.threads,
                LinearForce{1},
                Damping{scene.friction}};
    auto& p = gas.particles;
    p.x = run.start_x;
    p.m = m;
    p.h.assign(n, scene.h_over_dx * std::sqrt(pi / static_cast<double>(n)));
    gas.resolve(0);
    run.random_gradient_error = interpolate(p, p.x).gradient_error;
    // Friction acts on velocities: leapfrog is of second order for positions only, so the midpoint rule.
    gas.integrate_by<RungeKutta2>();
    gas.limit_steps([&] {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < n; ++i) least = std::min(least, p.h[i] / state.sound_speed(p.rho[i]));
        return std::min(scene.courant * least, 0.1);
    });
    double t = 0;
    march(gas, t, {.end = scene.time});
    gas.resolve(t);
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double exact = std::max(0.0, 1 - radius2(p.x, i));
        run.density_error += p.m[i] * std::abs(p.rho[i] - exact);
        size += p.m[i] * exact;
        run.speed += p.m[i] * (square(p.v[0][i]) + square(p.v[1][i]));
    }
    const Totals<2> totals = gas.totals();
    run.density_error /= size;
    run.speed = std::sqrt(run.speed / totals.mass);
    for (const double component : totals.momentum)
        run.momentum = std::max(run.momentum, std::abs(component) / totals.mass);
    run.nearest = mean_nearest(p);
    const Interpolated interpolated = interpolate(p, p.x);
    run.function = interpolated.function;
    run.gradient = interpolated.gradient;
    run.function_error = interpolated.function_error;
    run.gradient_error = interpolated.gradient_error;
    run.x = p.x;
    run.rho = p.rho;
    run.m = p.m;
    run.h = p.h;
    run.counters = gas.counters();
    return run;
}

report::Quantities DiscRun::measured() const {
    return {{"l1_rho", density_error},        {"linf_f", function_error},
            {"rms_slope", gradient_error},    {"rms_slope_before", random_gradient_error},
            {"nearest", nearest, "spacings"}, {"rms_speed", speed},
            {"momentum_drift", momentum},     {"steps", static_cast<double>(counters.steps)}};
}

}  // namespace sph::euler
