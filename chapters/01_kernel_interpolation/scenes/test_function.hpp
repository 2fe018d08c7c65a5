#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/vec.hpp"

/// The function that this chapter interpolates: smooth, of period 1, without symmetry that could hide an
/// error.
namespace sph::interpolation {

/// A = exp(sin 2 pi x) in 1D and exp(sin 2 pi x) cos 2 pi y in 2D, with derivatives; A_0 = 1, lengths in box
/// lengths.
template <int d>
struct TestFunction {
    static_assert(d == 1 || d == 2);
    static constexpr double k = 2 * pi;

    static double value(const Vector<d>& x) { return along_x(x) * along_y(x, 0); }
    static Vector<d> gradient(const Vector<d>& x) {
        const double slope = k * std::cos(k * x[0]) * along_x(x);
        if constexpr (d == 1) return {slope};
        if constexpr (d == 2) return {slope * along_y(x, 0), along_x(x) * along_y(x, 1)};
    }
    static double laplacian(const Vector<d>& x) {
        const double c = std::cos(k * x[0]), s = std::sin(k * x[0]);
        return k * k * (c * c - s) * along_x(x) * along_y(x, 0) + (d == 2 ? along_x(x) * along_y(x, 2) : 0.0);
    }
    double operator()(const Vector<d>& x) const { return value(x); }

  private:
    static double along_x(const Vector<d>& x) { return std::exp(std::sin(k * x[0])); }
    /// The `order`-th derivative of cos k y (1D: of the constant 1).
    static double along_y(const Vector<d>& x, int order) {
        if constexpr (d == 1) return order == 0 ? 1 : 0;
        if constexpr (d == 2) {
            const double y = k * x[1];
            return order == 0 ? std::cos(y) : order == 1 ? -k * std::sin(y) : -k * k * std::cos(y);
        }
    }
};

}  // namespace sph::interpolation
