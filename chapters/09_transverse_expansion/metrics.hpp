#pragma once
#include <tuple>

#include "common/core/particles.hpp"

/// Coordinates in which the time stands at a right angle to space (Chen 2017, 304, 305), as small types:
///     ds^2 = g_00 dt^2 - sum_a g_a (dx^a)^2,   g_00, g_a > 0; c = 1.
/// at(t, x) gives what the equation of motion needs of them at a time and a place; effects(t) the terms that
/// their gradients add to it, as a tuple of effects (322, second and third line): none where they have none.
namespace sph {

template <int d>
struct MetricValues {
    double g_00 = 1;
    Vector<d> g{};      ///< g_a, positive
    double volume = 1;  ///< sqrt(-g) = sqrt(g_00 g_1 .. g_d), and of directions that nothing depends on
};

// [metrics]
/// (tau, x, y), where nothing depends on eta: ds^2 = dtau^2 - dx^2 - dy^2 - tau^2 deta^2   (334).
/// The only trace of the longitudinal expansion is sqrt(-g) = tau.
struct BoostInvariant {
    static constexpr int d = 2;
    using Columns = List<>;
    MetricValues<2> at(double tau, const Vector<2>&) const { return {1, {1, 1}, tau}; }
    auto effects(double) const { return std::tuple<>{}; }
};

/// (tau, x, y, z), z = unit eta: the same metric with eta measured in a length, so that a kernel can be round
/// in (x, y, z). unit > 0 [length].
struct Hyperbolic {
    static constexpr int d = 3;
    using Columns = List<>;
    double unit = 1;
    MetricValues<3> at(double tau, const Vector<3>&) const {
        const double a = tau / unit;
        return {1, {1, 1, a * a}, a};
    }
    auto effects(double) const { return std::tuple<>{}; }
};
// [end]

}  // namespace sph
