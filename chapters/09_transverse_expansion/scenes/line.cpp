#include "chapters/09_transverse_expansion/scenes/line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/09_transverse_expansion/curved_line.hpp"
#include "common/core/unstable.hpp"

namespace sph::transverse {
namespace {

using LineKernel = AnyKernel<1>;

/// The faces of n rings in r < R, whose widths shrink towards the edge as the square root of the distance.
Column ring_faces(double R, std::size_t n) {
    Column faces(n + 1);
    for (std::size_t i = 0; i <= n; ++i)
        faces[i] = R * std::sin(pi / 2 * static_cast<double>(i) / static_cast<double>(n));
    return faces;
}

// [line]
std::unique_ptr<Integrated<1>> line_of(const LineScene& scene) {
    constexpr double close = 1e-7, first_step = 0.05, growth = 1.1, share_of_tau = 0.1;
    const auto& [R, tau0, c2] = scene.flow;
    const Column faces = ring_faces(R, scene.n);
    const auto axis = behind_the_axis(scene.share);
    using Resolution = ConsistentH<LineKernel, OfCurvedEntropy>;
    auto fluid = std::make_unique<CurvedFluid<Resolution, ConformalFluid, Cylindrical, decltype(axis)>>(
        scene.n, Resolution{HRule{scene.h_over_dx}, close, LineKernel{"wendland-c4"}}, ConformalFluid{c2},
        Cylindrical{}, axis, scene.threads);
    for (std::size_t i = 0; i < scene.n; ++i) {
        fluid->particles.x[0][i] = 0.5 * (faces[i] + faces[i + 1]);
        fluid->particles.s_star[i] = tau0 * fluid->particles.x[0][i];
        fluid->particles.nu[i] = fluid->particles.s_star[i] * (faces[i + 1] - faces[i]);
    }
    fluid->start(tau0);
    fluid->template integrate_by<RungeKutta4>();
    fluid->limit_steps([&line = *fluid, courant = scene.courant, longest = 0.0]() mutable {
        const double tau = line.resolved_at();
        const double allowed = std::min(courant * line.crossing_time(tau), share_of_tau * tau);
        longest = longest > 0 ? std::min(growth * longest, allowed) : first_step * allowed;
        return longest;
    });
    return fluid;
}
// [end]

LineProfile line_profile(const Integrated<1>& fluid, const LineScene& scene,
                         const exact::TransverseProfile& solution) {
    const double tau = solution.tau();
    LineProfile profile;
    profile.time = tau;
    profile.r = fluid.get<Position>()[0];
    double difference = 0, whole = 0;
    for (std::size_t i = 0; i < profile.r.size(); ++i) {
        const double r = profile.r[i], U = fluid.get<FourVelocity>()[0][i];
        const double s_star = fluid.get<EntropyDensity>()[i];
        const double T = std::pow(s_star / (tau * r * std::sqrt(1 + U * U)), scene.flow.c2);
        const auto state = solution.at(r);
        profile.temperature.push_back(T);
        profile.u_r.push_back(U);
        profile.exact_temperature.push_back(state.temperature);
        profile.exact_u_r.push_back(std::sinh(state.rapidity));
        if (r >= scene.flow.radius) continue;
        const double area = r * fluid.get<Entropy>()[i] / s_star;
        difference += area * std::abs(T - state.temperature);
        whole += area * state.temperature;
        const double off = std::abs(T / state.temperature - 1);
        if (r < scene.flow.radius / 20) {
            profile.axis = std::max(profile.axis, off);
        } else if (r < scene.flow.radius / 2) {
            profile.inside = std::max(profile.inside, off);
        }
    }
    profile.l1_temperature = difference / whole;
    return profile;
}

/// F/h of the cubic spline's W in one dimension, and W, at a distance.
struct KernelAt {
    double W, slope;
};
KernelAt cubic_at(double x, double h) {
    const double q = std::abs(x) / h, one = std::max(0.0, 1 - q), two = std::max(0.0, 2 - q);
    const double W = (two * two * two - 4 * one * one * one) / (6 * h);
    const double dq = (-3 * two * two + 12 * one * one) / (6 * h * h);
    return {W, x < 0 ? -dq : dq};
}

}  // namespace

report::Quantities LineProfile::measured() const {
    return {{"l1_temperature", l1_temperature},
            {"axis", axis},
            {"inside", inside},
            {"entropy_drift", entropy},
            {"steps", static_cast<double>(counters.steps)},
            {"pairs", static_cast<double>(counters.pairs)}};
}

std::vector<exact::TransverseProfile> exact_lines(const exact::TransverseFlow& flow,
                                                  const std::vector<double>& times) {
    std::vector<exact::TransverseProfile> all;
    for (const double tau : times) all.emplace_back(flow, tau);
    return all;
}

std::vector<LineProfile> run_line(const LineScene& scene,
                                  const std::vector<exact::TransverseProfile>& solutions) {
    if (scene.n < 10) throw std::invalid_argument{"fewer than ten rings"};
    const auto fluid = line_of(scene);
    double tau = scene.flow.tau0, seconds = 0;
    std::vector<LineProfile> profiles;
    for (const exact::TransverseProfile& solution : solutions) {
        seconds += march(*fluid, tau, {.end = solution.tau(), .progress = scene.progress}, [&](double now) {
                       require_order(fluid->get<Position>()[0], now);
                   }).seconds;
        fluid->resolve(tau);
        LineProfile& profile = profiles.emplace_back(line_profile(*fluid, scene, solution));
        const double whole = scene.flow.tau0 * square(scene.flow.radius) / 2;
        profile.entropy = fluid->totals().mass / whole - 1;
        profile.seconds = seconds;
        profile.counters = fluid->counters();
    }
    return profiles;
}

std::vector<LineProfile> run_line(const LineScene& scene) {
    return run_line(scene, exact_lines(scene.flow, scene.times));
}

double unpaired_force(std::size_t n, bool inside) {
    constexpr double smoothed_over = 2, support = 2;
    const double dr = 1 / static_cast<double>(n), h = smoothed_over * dr;
    const auto far = static_cast<std::size_t>(smoothed_over * support);
    const auto r = [&](std::size_t i) { return (static_cast<double>(i) + 0.5) * dr; };
    const auto pairs_of = [&](std::size_t i, const auto& visit) {
        const std::size_t last = std::min(n - 1, i + far);
        for (std::size_t j = i - std::min(i, far); j <= last; ++j) visit(j, cubic_at(r(i) - r(j), h));
    };
    Column s(n);
    for (std::size_t i = 0; i < n; ++i)
        pairs_of(
            i, [&](std::size_t j, const KernelAt& at) { s[i] += r(j) * dr * at.W / (inside ? r(i) : r(j)); });
    double sum = 0, magnitude = 0;
    for (std::size_t i = 0; i < n; ++i) {
        pairs_of(i, [&](std::size_t j, const KernelAt& at) {
            if (i == j) return;
            // By L = -sum nu eps/s and d(eps/s) = P/s^2 ds: what moving i does to s_i and s_j through this
            // pair.
            const double of_i = at.slope / (inside ? r(i) : r(j));
            const double of_j = inside ? at.slope / r(j) : at.slope / r(i) - at.W / (r(i) * r(i));
            const double by_s_i = std::pow(s[i], -2.0 / 3) / 3, by_s_j = std::pow(s[j], -2.0 / 3) / 3;
            const double force = -r(i) * dr * r(j) * dr * (by_s_i * of_i + by_s_j * of_j);
            sum += force;
            magnitude += std::abs(force);
        });
    }
    return std::abs(sum) / magnitude;
}

}  // namespace sph::transverse
