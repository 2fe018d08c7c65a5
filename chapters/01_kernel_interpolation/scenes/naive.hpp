#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"

/// The cubic spline as papers print it, piece by piece: what one writes first. It is here to be compared
/// with. Two things are wrong with it: branches that no compiler can turn into vector code and no processor
/// can predict, and F = w'(q)/q, which is 0/0 for coincident particles and loses digits like eps/q close to
/// them.
namespace sph::interpolation {

template <int d>
struct PiecewiseCubic : Kernel<PiecewiseCubic<d>, d> {
    static constexpr std::string_view name = "cubic, piecewise";
    static constexpr double support = 2;
    static constexpr double sigma = by_dimension<d>(1.0 / 6, 5 / (14 * pi), 1 / (4 * pi));

    static constexpr double w(double q) {
        if (q < 1) return cube(2 - q) - 4 * cube(1 - q);
        if (q < 2) return cube(2 - q);
        return 0;
    }
    static constexpr double slope(double q) {
        if (q < 1) return -3 * square(2 - q) + 12 * square(1 - q);
        if (q < 2) return -3 * square(2 - q);
        return 0;
    }
    static constexpr double f(double q) { return slope(q) / q; }
};

}  // namespace sph::interpolation
