#include "chapters/03_euler_sph/scenes/wave.hpp"

#include "chapters/03_euler_sph/dispersion.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

template <class G>
double velocity_error(const G& gas, const WaveScene& scene, double t) {
    double error = 0, size = 0;
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = gas.particles.x[0][i];
        error += std::abs(gas.particles.v[0][i] - scene.velocity(x, t));
        size += std::abs(scene.velocity(x, 0));
    }
    return error / size;
}

template <class Resolution>
WaveRun run(const WaveScene& scene, const Resolution& resolution) {
    auto gas = wave_gas(scene, resolution);
    auto& p = gas.particles;
    RungeKutta4<typename WaveGas<Resolution>::Motion> integrator{gas.counters()};
    const auto rates = [&](double time) { gas.rates(time); };
    gas.resolve(0);
    const double start = gas.energy(), scale = square(scene.amplitude) / 4;
    const double period = 1.0 / scene.waves;
    const auto steps = static_cast<int>(std::ceil(period / (scene.courant * scene.spacing())));
    WaveRun result;
    const double begin = report::thread_cpu_seconds();
    double t = 0;
    for (int step = 0; step < steps; ++step) {
        integrator.step(p, t, period / steps, rates);
        gas.resolve(t);
        result.t.push_back(t);
        result.error_at.push_back(velocity_error(gas, scene, t));
        result.error = std::max(result.error, result.error_at.back());
        result.energy_drift = std::max(result.energy_drift, std::abs(gas.energy() - start) / scale);
        result.momentum_drift =
            std::max(result.momentum_drift, std::abs(gas.momentum()[0]) / scene.amplitude);
    }
    result.seconds = report::thread_cpu_seconds() - begin;
    for (std::size_t i = 0; i < scene.n; ++i) result.exact.push_back(scene.velocity(p.x[0][i], t));
    result.x = p.x[0];
    result.v = p.v[0];
    result.counters = gas.counters();
    return result;
}

/// The part of the velocity that is the wave.
template <class P>
double projection(const P& p, const WaveScene& scene) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * scene.spacing();
        sum += p.v[0][i] * std::sin(scene.k() * x);
    }
    return sum;
}

/// With leapfrog the projection is cos(step a), sin(a/2) = omega dt/2. The first zero after the given number
/// of periods is found by linear interpolation of the phase between two steps.
template <class Resolution>
double omega2(const WaveScene& scene, const Resolution& resolution, int periods) {
    auto gas = wave_gas(scene, resolution);
    auto& p = gas.particles;
    KickDriftKick<typename WaveGas<Resolution>::Motion> integrator{gas.counters()};
    const auto rates = [&](double time) { gas.rates(time); };
    const double dt = scene.courant * scene.spacing(), start = projection(p, scene);
    double t = 0, before = 1;
    int zeros = 0;
    for (int step = 1;; ++step) {
        integrator.step(p, t, dt, rates);
        const double now = projection(p, scene) / start;
        zeros += (before > 0) != (now > 0) ? 1 : 0;
        if (zeros == 2 * periods) {
            // now = cos(step a) and the phase step a lies just beyond (2 periods - 1/2) pi.
            const double phase = (2 * periods - 0.5) * std::numbers::pi + std::asin(now);
            const double a = phase / step;
            return square(2 / dt * std::sin(a / 2));
        }
        before = now;
    }
}

}  // namespace

WaveRun run_wave(const WaveScene& scene, const GasScheme& scheme) {
    return with_scheme(scheme, scene.spacing(),
                       [&](const auto& resolution) { return run(scene, resolution); });
}

double measured_omega2(const WaveScene& given, const GasScheme& given_scheme, int periods) {
    WaveScene scene = given;
    GasScheme scheme = given_scheme;
    with_kernel<1>(scheme.kernel, [&](const auto& kernel) {
        scene.density = lattice_density<std::decay_t<decltype(kernel)>>(scheme.h_over_dx);
    });
    if (scheme.resolution != "fixed-h") scheme.h_over_dx *= scene.density;  // h = sigma m/rho
    return with_scheme(scheme, scene.spacing(),
                       [&](const auto& resolution) { return omega2(scene, resolution, periods); });
}

}  // namespace sph
