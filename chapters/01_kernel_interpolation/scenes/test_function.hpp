#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/vec.hpp"

/// The function that this chapter interpolates: smooth, of period 1, without symmetry that could hide an
/// error.
namespace sph::interpolation {

/// A = exp(sin 2 pi x) in 1D, times cos 2 pi y in 2D, times cos 2 pi z in 3D, with derivatives; A_0 = 1,
/// lengths in box lengths.
template <int d>
struct TestFunction {
    static constexpr double k = 2 * pi;

    static double value(const Vector<d>& x) { return along_x(x) * across(x); }
    static Vector<d> gradient(const Vector<d>& x) {
        Vector<d> slope{};
        slope[0] = k * std::cos(k * x[0]) * value(x);
        for (std::size_t a = 1; a < d; ++a) slope[a] = -k * std::sin(k * x[a]) * along_x(x) * across(x, a);
        return slope;
    }
    static double laplacian(const Vector<d>& x) {
        const double c = std::cos(k * x[0]), s = std::sin(k * x[0]);
        return k * k * (c * c - s - (d - 1)) * value(x);
    }
    double operator()(const Vector<d>& x) const { return value(x); }

  private:
    static double along_x(const Vector<d>& x) { return std::exp(std::sin(k * x[0])); }
    /// The product of the cosines of all other axes but `without`.
    static double across(const Vector<d>& x, std::size_t without = 0) {
        double product = 1;
        for (std::size_t a = 1; a < d; ++a) {
            if (a != without) product *= std::cos(k * x[a]);
        }
        return product;
    }
};

}  // namespace sph::interpolation
