#pragma once
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "chapters/09_transverse_expansion/curved_fluid.hpp"
#include "common/core/boundary.hpp"

/// Coordinates along a line in which sqrt(-g) and g_00 vary, and what their gradients do to a particle.
namespace sph {

// [gradients]
/// dq_i/dt += P/(u^0 s) d ln sqrt(-g)/dx   (322, second line). As u^0 s = s*/sqrt(-g) it is P~/s* times that.
/// Metric: log_volume_slope(x).
template <class Metric>
struct VolumeGradient {
    Metric metric;
    using ReadsI = List<Position, EntropyDensity, WeighedPressure>;
    using Writes = List<MomentumRate>;
    void finish(const auto& i, const auto&, auto& out) const {
        out.dq_dt[0] += i.p_tilde / i.s_star * metric.log_volume_slope(i.x[0]);
    }
};
/// dq_i/dt -= u^0 w/2 dg_00/dx   (322, last line, where + is printed): weight. With w u^0 = (eps + P) (u^0)^2
/// sqrt(-g)/s*, eps + P = (1 + 1/c2) P and (u^0)^2 = (1 + U^2)/g_00, in coordinates with g_1 = 1.
/// Metric: log_g_00_slope(x). sign: -1, or 1 as printed.
template <class Metric>
struct Weight {
    Metric metric;
    double c2, sign = -1;
    using ReadsI = List<Position, EntropyDensity, WeighedPressure, FourVelocity>;
    using Writes = List<MomentumRate>;
    void finish(const auto& i, const auto&, auto& out) const {
        const double inertia = (1 + 1 / c2) * i.p_tilde / i.s_star * (1 + i.U[0] * i.U[0]);
        out.dq_dt[0] += 0.5 * sign * inertia * metric.log_g_00_slope(i.x[0]);
    }
};
// [end]

/// (tau, r), where nothing depends on phi and eta: ds^2 = dtau^2 - dr^2 - r^2 dphi^2 - tau^2 deta^2, so
/// sqrt(-g) = tau r. For r > 0.
struct Cylindrical {
    static constexpr int d = 1;
    using Columns = List<>;
    MetricValues<1> at(double tau, const Vector<1>& r) const { return {1, {1}, tau * r[0]}; }
    double log_volume_slope(double r) const { return 1 / r; }
    auto effects(double) const { return std::tuple{VolumeGradient<Cylindrical>{*this}}; }
};
/// (t, x) of observers who hover with the acceleration 1/x each (Rindler's): ds^2 = a^2 x^2 dt^2 - dx^2, so
/// sqrt(-g) = a x. a > 0, x > 0; p = c2 eps.
struct Rindler {
    static constexpr int d = 1;
    using Columns = List<>;
    double a = 1, c2 = 1.0 / 3;
    double sign = -1;  ///< of the weight
    MetricValues<1> at(double, const Vector<1>& x) const { return {a * a * x[0] * x[0], {1}, a * x[0]}; }
    double log_volume_slope(double x) const { return 1 / x; }
    double log_g_00_slope(double x) const { return 2 / x; }
    auto effects(double) const {
        return std::tuple{VolumeGradient<Rindler>{*this}, Weight<Rindler>{*this, c2, sign}};
    }
};

/// Images of the particles behind the axis r = 0, with `share` of their entropy. s* = tau r s u^0 is odd in
/// r: images with share -1 continue it as it is, but a ring and its image attract each other and become
/// nothing on the axis. With 1, mirror images, rings keep away from it, and s* gets the corner of |r|.
inline auto behind_the_axis(double share) {
    const auto make = [](const Columns<1>& r, double reach, std::vector<Ghost<1>>& ghosts) {
        for (std::size_t i = 0; i < r[0].size(); ++i)
            if (r[0][i] < reach) ghosts.push_back({static_cast<std::uint32_t>(i), {-r[0][i]}, {-1}});
    };
    const auto set = [share](auto& row, const auto&) {
        if constexpr (requires { row.nu; }) row.nu *= share;
    };
    return GhostsOf{make, set};
}

}  // namespace sph
