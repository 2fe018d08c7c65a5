#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"

/// Schoenberg's M_n splines (Monaghan 2005, 2.4-2.6; Chen 2017, 55-58), without branches.
///
/// M_n is a sum of powers (c - q)_+^(n-1), where ( )_+ is the positive part: the pieces switch themselves
/// off, so the formula is one expression for every q, and the compiler can evaluate many q at once.
///
/// The gradient factor f = w'/q needs care near q = 0, where w' is a difference of nearly equal powers:
/// dividing it by q loses all digits there, and 0/0 is NaN for coincident particles. On the innermost piece
/// w'/q is a polynomial. With c the innermost positive part, f is written as
///     f = (w' without the innermost power) / max(q, c_0)  +  polynomial in c,
/// where c_0 is the innermost joint; the polynomial (derived by expanding both sides in c = c_0 - q) vanishes
/// with c.
namespace sph {

/// M_2, the hat: the bad example (Monaghan 2005, 2.5). Its slope jumps at q = 0 and at q = 1, so a gradient
/// leaps when a particle enters the support, and neighbours that meet still push each other apart. Support h;
/// not among the kernels that options know. Normalisation 1, 3/pi, 3/pi: by integration.
template <int d>
struct HatSpline : Kernel<HatSpline<d>, d> {
    static constexpr std::string_view name = "hat";
    static constexpr double support = 1;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma = by_dimension<d>(1, 3 / pi, 3 / pi);

    template <class T>
    static constexpr T w(const T& q) {
        return positive_part(1.0 - q);
    }
    /// -1/q: without a limit at q = 0, where it is cut off.
    template <class T>
    static constexpr T f(const T& q) {
        return zero_beyond(1.0, q, T(-1.0 / at_least(q, 1e-9)));
    }
    template <class T>
    static constexpr T d2w(const T&) {
        return T(0.0);
    }
};

/// M_3, the quadratic spline of the family: support 1.5h, one continuous
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
        return square(positive_part(1.5 - q)) - 3.0 * square(positive_part(0.5 - q));
    }
    template <class T>
    static constexpr T f(const T& q) {
        return -2.0 * positive_part(1.5 - q) / at_least(q, 0.5) + 4.0 * positive_part(0.5 - q);
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        return zero_beyond(1.5, q, T(2.0)) - zero_beyond(0.5, q, T(6.0));
    }
};

/// M_4, the cubic spline. Support 2h, two continuous derivatives.
/// Normalisation 1/6, 5/(14 pi), 1/(4 pi); Monaghan 2005 prints 15/(14 pi) for 2D, which integrates to 3.
template <int d>
struct CubicSpline : Kernel<CubicSpline<d>, d> {
    static constexpr std::string_view name = "cubic";
    static constexpr double support = 2;
    static constexpr std::array joints{1.0};
    static constexpr double sigma = by_dimension<d>(1.0 / 6, 5 / (14 * pi), 1 / (4 * pi));

    // [cubic]
    template <class T>
    static constexpr T w(const T& q) {
        return cube(positive_part(2.0 - q)) - 4.0 * cube(positive_part(1.0 - q));
    }
    template <class T>
    static constexpr T f(const T& q) {
        const T a = positive_part(2.0 - q);
        const T b = positive_part(1.0 - q);
        return -3.0 * square(a) / at_least(q, 1.0) + 3.0 * b * (b - 1.0);
    }
    // [end]
    template <class T>
    static constexpr T d2w(const T& q) {
        return 6.0 * positive_part(2.0 - q) - 24.0 * positive_part(1.0 - q);
    }
};

/// M_5, the quartic spline. Support 2.5h, three continuous derivatives.
/// Normalisation 1/24, 96/(1199 pi), 1/(20 pi).
template <int d>
struct QuarticSpline : Kernel<QuarticSpline<d>, d> {
    static constexpr std::string_view name = "quartic";
    static constexpr double support = 2.5;
    static constexpr std::array joints{0.5, 1.5};
    static constexpr double sigma = by_dimension<d>(1.0 / 24, 96 / (1199 * pi), 1 / (20 * pi));

    template <class T>
    static constexpr T w(const T& q) {
        return power<4>(positive_part(2.5 - q)) - 5.0 * power<4>(positive_part(1.5 - q)) +
               10.0 * power<4>(positive_part(0.5 - q));
    }
    template <class T>
    static constexpr T f(const T& q) {
        const T a = positive_part(2.5 - q);
        const T b = positive_part(1.5 - q);
        const T c = positive_part(0.5 - q);
        return (20.0 * cube(b) - 4.0 * cube(a)) / at_least(q, 0.5) - 16.0 * c * (3.0 + c * (3.0 + 2.0 * c));
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        return 12.0 * square(positive_part(2.5 - q)) - 60.0 * square(positive_part(1.5 - q)) +
               120.0 * square(positive_part(0.5 - q));
    }
};

/// M_6, the quintic spline. Support 3h, four continuous derivatives.
/// Normalisation 1/120, 7/(478 pi), 1/(120 pi).
template <int d>
struct QuinticSpline : Kernel<QuinticSpline<d>, d> {
    static constexpr std::string_view name = "quintic";
    static constexpr double support = 3;
    static constexpr std::array joints{1.0, 2.0};
    static constexpr double sigma = by_dimension<d>(1.0 / 120, 7 / (478 * pi), 1 / (120 * pi));

    template <class T>
    static constexpr T w(const T& q) {
        return power<5>(positive_part(3.0 - q)) - 6.0 * power<5>(positive_part(2.0 - q)) +
               15.0 * power<5>(positive_part(1.0 - q));
    }
    template <class T>
    static constexpr T f(const T& q) {
        const T a = positive_part(3.0 - q);
        const T b = positive_part(2.0 - q);
        const T c = positive_part(1.0 - q);
        return (30.0 * power<4>(b) - 5.0 * power<4>(a)) / at_least(q, 1.0) -
               c * (50.0 + c * (90.0 + c * (30.0 + 25.0 * c)));
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        return 20.0 * cube(positive_part(3.0 - q)) - 120.0 * cube(positive_part(2.0 - q)) +
               300.0 * cube(positive_part(1.0 - q));
    }
};

}  // namespace sph
