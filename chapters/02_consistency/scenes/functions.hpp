#pragma once
#include <cmath>
#include <functional>

#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"

/// The functions that this chapter interpolates, with their gradients.
namespace sph::consistency {

template <int d>
struct Function {
    std::function<double(const Vector<d>&)> value;
    std::function<Vector<d>(const Vector<d>&)> gradient;
};

/// exp(-|x - a|^2/w^2) + 0.7 exp(-|x - b|^2/u^2), a sum of two Gaussians as in Mota, Chen & Qian 2017, fig.
/// 1, and Chen 2017, figs 21-22, who do not give theirs: a = 0.35, w = 0.08, b = 0.65, u = 0.12 along each
/// axis. On a pedestal they do not vanish at the ends of the box, as theirs do.
template <int d>
Function<d> sum_of_gaussians(double pedestal = 0) {
    const auto bump = [](const Vector<d>& x, double centre, double width) {
        double r2 = 0;
        for (const double c : x) r2 += (c - centre) * (c - centre);
        return std::exp(-r2 / (width * width));
    };
    constexpr double a = 0.35, w = 0.08, b = 0.65, u = 0.12, weight = 0.7;
    return {[=](const Vector<d>& x) { return pedestal + bump(x, a, w) + weight * bump(x, b, u); },
            [=](const Vector<d>& x) {
                Vector<d> slope;
                for (std::size_t axis = 0; axis < d; ++axis) {
                    slope[axis] = -2 * (x[axis] - a) / (w * w) * bump(x, a, w) -
                                  2 * (x[axis] - b) / (u * u) * weight * bump(x, b, u);
                }
                return slope;
            }};
}

/// Chapter 1's function: smooth, and neither it nor its slope vanishes at the ends.
template <int d>
Function<d> wave() {
    using Wave = interpolation::TestFunction<d>;
    return {Wave::value, Wave::gradient};
}

/// constant + slope (x + 2 y + 3 z) + curvature x^2
template <int d>
Function<d> polynomial(double constant, double slope, double curvature) {
    return {[=](const Vector<d>& x) {
                double value = constant + curvature * x[0] * x[0];
                for (std::size_t a = 0; a < d; ++a) value += slope * static_cast<double>(a + 1) * x[a];
                return value;
            },
            [=](const Vector<d>& x) {
                Vector<d> gradient;
                for (std::size_t a = 0; a < d; ++a) gradient[a] = slope * static_cast<double>(a + 1);
                gradient[0] += 2 * curvature * x[0];
                return gradient;
            }};
}

/// A wave that drops by 0.7 at x = 0.5: with the same slope on both sides, or (kink) with another one behind.
inline Function<1> step_function(bool kink) {
    constexpr double k = 2 * pi;
    const auto behind = [](double x) { return x >= 0.5; };
    return {[=](const Vector<1>& x) {
                if (!behind(x[0])) return 1 + 0.2 * std::sin(k * x[0]);
                return 0.3 + (kink ? 0.1 * std::sin(2 * k * x[0]) : 0.2 * std::sin(k * x[0]));
            },
            [=](const Vector<1>& x) {
                if (behind(x[0]) && kink) return Vector<1>{0.2 * k * std::cos(2 * k * x[0])};
                return Vector<1>{0.2 * k * std::cos(k * x[0])};
            }};
}
inline constexpr double step_at = 0.5;

}  // namespace sph::consistency
