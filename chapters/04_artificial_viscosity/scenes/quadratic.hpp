#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"

namespace sph {

/// M_3, the quadratic spline of Schoenberg's family (chapter 1, splines.hpp): support 1.5h, one continuous
/// derivative. The narrowest spline whose gradient is continuous; at h = dx its sum over an even line is
/// exactly 1 (as that of every M_n), with three neighbours.
/// w = (1.5 - q)_+^2 - 3 (0.5 - q)_+^2. Normalisation 1/2, 16/(13 pi), 1/pi: by integration.
/// d2w has jumps at q = 0.5 and 1.5; at these points it takes the value from outside.
template <int d>
struct QuadraticSpline : Kernel<QuadraticSpline<d>, d> {
    static constexpr std::string_view name = "quadratic";
    static constexpr double support = 1.5;
    static constexpr std::array joints{0.5};
    static constexpr double sigma = by_dimension<d>(0.5, 16 / (13 * pi), 1 / pi);

    template <class T>
    static constexpr T w(const T& q) {
        return T(square(positive_part(T(1.5 - q))) - 3.0 * square(positive_part(T(0.5 - q))));
    }
    template <class T>
    static constexpr T f(const T& q) {
        return T(-2.0 * positive_part(T(1.5 - q)) / at_least(q, 0.5) + 4.0 * positive_part(T(0.5 - q)));
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        return T(zero_beyond(1.5, q, T(0.0 * q + 2.0)) - zero_beyond(0.5, q, T(0.0 * q + 6.0)));
    }
};

}  // namespace sph
