#include "chapters/03_euler_sph/scenes/star.hpp"

#include <Eigen/Eigenvalues>

#include "chapters/03_euler_sph/scenes/star_rest.hpp"
#include "common/exact/toy_star.hpp"
#include "common/exact/toy_star_modes.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

/// The part of a velocity that is the mode, weighted by mass.
template <class P>
double projection(const P& p, const Column& eigenfunction) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * p.v[0][i] * eigenfunction[i];
    return sum;
}

/// The exact radius-to-second-moment relation: <x^2> = R^2/(2/(gamma - 1) + 3).
template <class P>
double radius_of(const P& p, double gamma) {
    double mass = 0, moment = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        mass += p.m[i];
        moment += p.m[i] * square(p.x[0][i]);
    }
    return std::sqrt(moment / mass * (2 / (gamma - 1) + 3));
}

template <class Resolution>
StarRun mode(const StarScene& scene, const Resolution& resolution, int mode, int periods, double phase_step) {
    auto gas = star_gas(scene, resolution);
    const Eigen::MatrixXd J = relax(gas);
    auto& p = gas.particles;
    constexpr double amplitude = 1e-6;
    Column shape;
    for (std::size_t i = 0; i < scene.n; ++i) {
        shape.push_back(exact::toy_star_velocity(scene.gamma, mode, std::clamp(p.x[0][i], -1.0, 1.0)));
        p.v[0][i] = amplitude * shape[i];
    }
    // The fastest oscillation of the discrete star, by Gershgorin; RK4 is stable to 2.8 of its phase.
    const double fastest = std::sqrt(J.cwiseAbs().rowwise().sum().maxCoeff());
    const double expected = exact::toy_star_frequency(scene.gamma, mode);
    const double dt = std::min(2 / fastest, phase_step / expected);
    RungeKutta4<typename StarGas<Resolution>::Motion> integrator{gas.counters()};
    const auto rates = [&](double time) { gas.rates(time); };
    const double start = projection(p, shape);
    double t = 0, before = 1;
    std::vector<double> falls;  // times at which the velocity changes from + to -: whole periods apart
    StarRun run;
    while (falls.size() <= static_cast<std::size_t>(periods)) {
        integrator.step(p, t, dt, rates);
        const double now = projection(p, shape) / start;
        if (before > 0 && now <= 0) falls.push_back(t - std::asin(std::min(1.0, -now)) / expected);
        before = now;
    }
    run.omega = 2 * std::numbers::pi * periods / (falls.back() - falls.front());
    const double end = 2 * std::numbers::pi / expected * (periods + 1);  // all velocity again
    while (t < end) integrator.step(p, t, std::min(dt, end - t), rates);
    run.x = p.x[0];
    for (std::size_t i = 0; i < scene.n; ++i) {
        run.v.push_back(p.v[0][i] / amplitude);
        run.exact_v.push_back(shape[i] * std::cos(expected * t));
    }
    return run;
}

template <class Resolution>
NonlinearRun nonlinear(const StarScene& scene, const Resolution& resolution, double A_0, double time,
                       double courant) {
    auto gas = star_gas(scene, resolution);
    relax(gas);
    auto& p = gas.particles;
    for (std::size_t i = 0; i < scene.n; ++i) p.v[0][i] = A_0 * p.x[0][i];
    const exact::ToyStar star{scene.gamma, scene.state().K, 1, A_0, 1, 1};
    KickDriftKick<typename StarGas<Resolution>::Motion> integrator{gas.counters()};
    const auto rates = [&](double now) { gas.rates(now); };
    gas.rates(0);
    gas.counters() = {};  // of the oscillation only
    const double start = gas.energy();
    NonlinearRun run;
    // Time steps suit the star at its smallest: spacing/c_s goes as radius^((gamma + 1)/2).
    double smallest = 1;
    for (int k = 0; k <= 1000; ++k) smallest = std::min(smallest, star.at(star.period() * k / 1000).radius);
    double rest = gas.time_step(courant, [&](std::size_t i) { return p.m[i] / p.rho[i]; });
    const auto steps = static_cast<int>(std::ceil(time / (rest * std::pow(smallest, (scene.gamma + 1) / 2))));
    double t = 0;
    const double begin = report::thread_cpu_seconds();
    const int shown = std::max(1, steps / 400);
    for (int step = 1; step <= steps; ++step) {
        integrator.step(p, t, time / steps, rates);
        run.energy_drift = std::max(run.energy_drift, std::abs(gas.energy() / start - 1));
        if (step % shown != 0 && step != steps) continue;
        run.t.push_back(t);
        run.radius.push_back(radius_of(p, scene.gamma));
    }
    run.seconds = report::thread_cpu_seconds() - begin;
    for (std::size_t k = 0; k < run.t.size(); ++k) {
        run.exact_radius.push_back(star.at(run.t[k]).radius);
        run.radius_error = std::max(run.radius_error, std::abs(run.radius[k] / run.exact_radius[k] - 1));
    }
    const auto end = star.at(t);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double x = p.x[0][i], width = p.m[i] / p.rho[i];
        run.exact_rho.push_back(end.density(x));
        run.exact_v.push_back(end.velocity(x));
        error += width * std::abs(p.v[0][i] - run.exact_v[i]);
        size += width * std::abs(run.exact_v[i]);
    }
    run.velocity_error = error / size;
    run.momentum = gas.momentum()[0];
    run.counters = gas.counters();
    run.x = p.x[0];
    run.rho = p.rho;
    run.v = p.v[0];
    return run;
}

}  // namespace

std::vector<double> star_frequencies(const StarScene& scene, const GasScheme& scheme, int modes) {
    return with_scheme(scheme, 2.0 / static_cast<double>(scene.n), [&](const auto& resolution) {
        auto gas = star_gas(scene, resolution);
        const Eigen::EigenSolver<Eigen::MatrixXd> solver{relax(gas), false};
        std::vector<double> omega;
        for (const auto& value : solver.eigenvalues())
            omega.push_back(std::sqrt(std::max(0.0, -value.real())));
        std::sort(omega.begin(), omega.end());
        omega.resize(static_cast<std::size_t>(modes));
        return omega;
    });
}

Column star_omega(const StarScene& scene, const GasScheme& scheme) {
    return with_scheme(scheme, 2.0 / static_cast<double>(scene.n), [&](const auto& resolution) {
        auto gas = star_gas(scene, resolution);
        relax(gas);
        if constexpr (requires { gas.particles.Omega; }) return gas.particles.Omega;
        return Column{};
    });
}

StarRun run_mode(const StarScene& scene, const GasScheme& scheme, int number, int periods,
                 double phase_step) {
    return with_scheme(scheme, 2.0 / static_cast<double>(scene.n), [&](const auto& resolution) {
        return mode(scene, resolution, number, periods, phase_step);
    });
}

NonlinearRun run_nonlinear(const StarScene& scene, const GasScheme& scheme, double A_0, double time,
                           double courant) {
    return with_scheme(scheme, 2.0 / static_cast<double>(scene.n), [&](const auto& resolution) {
        return nonlinear(scene, resolution, A_0, time, courant);
    });
}

}  // namespace sph
