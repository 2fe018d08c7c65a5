#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <numbers>
#include <string_view>
#include <type_traits>

/// What every smoothing kernel is made of: a shape w(q) of q = r/h with compact support, and its scaling with
/// the smoothing length h and the dimension.
///
/// The argument T of the shapes is a number (double, long double, std::complex for derivatives by complex
/// step) or a tile of eight (common/core/tile.hpp): one formula serves tests, scalar loops and passes.
namespace sph {

template <class T>
concept Number = std::floating_point<T>;

template <class T>
constexpr T square(const T& x) {
    return x * x;
}
template <class T>
constexpr T cube(const T& x) {
    return x * x * x;
}
/// x^n by squaring; n >= 1 is known at compile time, so this unrolls into at most 2 log2(n) products.
template <int n, class T>
constexpr T power(const T& x) {
    if constexpr (n == 1) {
        return x;
    } else if constexpr (n % 2 == 0) {
        return square(power<n / 2>(x));
    } else {
        return x * power<n - 1>(x);
    }
}

/// max(x, 0): with it a piecewise polynomial is one expression without branches. A complex number counts by
/// its real part, which is what differentiation by complex step needs.
template <class T>
constexpr T positive_part(const T& x) {
    if constexpr (Number<T>) {
        return x > 0 ? x : T(0);
    } else if constexpr (requires { x.max(0.0); }) {
        return x.max(0.0);
    } else {
        return x.real() > 0 ? x : T(0);
    }
}

/// max(x, floor), with the same meaning for each T as positive_part.
template <class T>
constexpr T at_least(const T& x, double floor) {
    return positive_part(x - floor) + floor;
}

/// `value` where q < limit and 0 elsewhere.
template <class T>
constexpr T zero_beyond(double limit, const T& q, const T& value) {
    if constexpr (Number<T>) {
        return q < limit ? value : T(0);
    } else if constexpr (requires { (q < limit).select(value, 0.0); }) {
        return (q < limit).select(value, 0.0);
    } else {
        return q.real() < limit ? value : T(0);
    }
}

/// n^d for the small integer d.
template <class T>
constexpr T to_dimension(int d, const T& x) {
    return d == 1 ? x : d == 2 ? x * x : x * x * x;
}

/// The scaling that all kernels share; Shape is the kernel itself (so that nothing is virtual). Shape
/// provides
///   support   cut-off radius in units of h [-]
///   joints    the q in (0, support) where the polynomial changes, for quadrature and for tests of smoothness
///   sigma     normalisation: the integral of sigma w(|x|) over d dimensions is 1
///   w, f, d2w the shape, its gradient factor f = (dw/dq)/q (finite at q = 0), and its second derivative
/// and inherits, for r >= 0 and h > 0 in the same unit of length L:
template <class Shape, int d>
struct Kernel {
    static_assert(d >= 1 && d <= 3);
    static constexpr int dimension = d;

    /// dw/dq = q f(q): exact zero at q = 0, no division.
    template <class T>
    static constexpr T dw(const T& q) {
        return q * Shape::f(q);
    }
    // r is a number or a tile of them, h a number or, if every pair has its own, a tile.
    /// W(r, h) = sigma/h^d w(r/h)   [1/L^d]
    template <class T, class H>
    static constexpr T W(const T& r, const H& h) {
        return (Shape::sigma / to_dimension(d, h)) * Shape::w(r * (1.0 / h));
    }
    /// dW/dr = sigma/h^(d+1) w'(r/h)   [1/L^(d+1)]
    template <class T, class H>
    static constexpr T dW_dr(const T& r, const H& h) {
        return (Shape::sigma / (to_dimension(d, h) * h)) * dw(r * (1.0 / h));
    }
    /// d2W/dr2 = sigma/h^(d+2) w''(r/h)   [1/L^(d+2)]
    template <class T, class H>
    static constexpr T d2W_dr2(const T& r, const H& h) {
        return (Shape::sigma / (to_dimension(d, h) * h * h)) * Shape::d2w(r * (1.0 / h));
    }
    /// The gradient factor: grad_i W(x_ij, h) = x_ij F(r_ij, h), F <= 0 for monotonic kernels (Monaghan
    /// 2005, 2.19). Finite at r = 0: coincident particles need no special case.   [1/L^(d+2)]
    template <class T, class H>
    static constexpr T F(const T& r, const H& h) {
        return (Shape::sigma / (to_dimension(d, h) * h * h)) * Shape::f(r * (1.0 / h));
    }
    /// dW/dh at fixed r = -sigma/h^(d+1) (d w + q w')   [1/L^(d+1)]
    template <class T, class H>
    static constexpr T dW_dh(const T& r, const H& h) {
        const T q = r * (1.0 / h);
        return (-Shape::sigma / (to_dimension(d, h) * h)) * (double(d) * Shape::w(q) + q * dw(q));
    }
};

/// A normalisation constant that differs between dimensions.
template <int d>
constexpr double by_dimension(double in_1d, double in_2d, double in_3d) {
    return d == 1 ? in_1d : d == 2 ? in_2d : in_3d;
}

inline constexpr double pi = std::numbers::pi;

}  // namespace sph
