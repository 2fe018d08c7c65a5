#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"

/// Polynomial kernels of one piece: Lucy's and Wendland's, with s = r/(2h).
///
/// All have support 2h here, so that a given h means comparable widths for every kernel of the book; their
/// authors write them for support 1 (the normalisations below are theirs divided by 2^d). Wendland (1995)
/// proved his functions to be positive definite up to a given dimension: those for one dimension have lower
/// degree than those that serve two and three.
namespace sph {

/// Lucy (1977): (1 - s)^3 (1 + 3s); printed in Monaghan 2005, after 2.3. Two continuous derivatives at the
/// edge.
template <int d>
struct Lucy : Kernel<Lucy<d>, d> {
    static constexpr std::string_view name = "lucy";
    static constexpr double support = 2;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma = by_dimension<d>(5.0 / 8, 5 / (4 * pi), 105 / (128 * pi));

    template <class T>
    static constexpr T w(const T& q) {
        return cube(positive_part(1.0 - 0.5 * q)) * (1.0 + 1.5 * q);
    }
    template <class T>
    static constexpr T f(const T& q) {
        return -3.0 * square(positive_part(1.0 - 0.5 * q));
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        return -3.0 * positive_part(1.0 - 0.5 * q) * (1.0 - 1.5 * q);
    }
};

/// Wendland C2: (1 - s)^3 (1 + 3s) in 1D (Lucy's polynomial), (1 - s)^4 (1 + 4s) in 2D and 3D.
template <int d>
struct WendlandC2 : Kernel<WendlandC2<d>, d> {
    static constexpr std::string_view name = "wendland-c2";
    static constexpr double support = 2;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma = by_dimension<d>(5.0 / 8, 7 / (4 * pi), 21 / (16 * pi));
    static constexpr int n = d == 1 ? 3 : 4;

    template <class T>
    static constexpr T w(const T& q) {
        return power<n>(positive_part(1.0 - 0.5 * q)) * (1.0 + 0.5 * n * q);
    }
    template <class T>
    static constexpr T f(const T& q) {
        return (-0.25 * n * (n + 1)) * power<n - 1>(positive_part(1.0 - 0.5 * q));
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        return (-0.25 * n * (n + 1)) * power<n - 2>(positive_part(1.0 - 0.5 * q)) * (1.0 - 0.5 * n * q);
    }
};

/// Wendland C4: (1 - s)^5 (1 + 5s + 8s^2) in 1D, (1 - s)^6 (1 + 6s + 35/3 s^2) in 2D and 3D.
template <int d>
struct WendlandC4 : Kernel<WendlandC4<d>, d> {
    static constexpr std::string_view name = "wendland-c4";
    static constexpr double support = 2;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma = by_dimension<d>(3.0 / 4, 9 / (4 * pi), 495 / (256 * pi));
    static constexpr bool line = d == 1;
    static constexpr int n = line ? 5 : 6;

    template <class T>
    static constexpr T w(const T& q) {
        const T s = 0.5 * q;
        return power<n>(positive_part(1.0 - s)) * (1.0 + s * (double(n) + (line ? 8.0 : 35.0 / 3) * s));
    }
    template <class T>
    static constexpr T f(const T& q) {
        const T s = 0.5 * q;
        return (line ? -3.5 : -14.0 / 3) * power<n - 1>(positive_part(1.0 - s)) *
               (1.0 + (line ? 4.0 : 5.0) * s);
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        const T s = 0.5 * q;
        return (line ? -3.5 : -14.0 / 3) * power<n - 2>(positive_part(1.0 - s)) *
               (1.0 + s * ((line ? 3.0 : 4.0) - (line ? 24.0 : 35.0) * s));
    }
};

/// Wendland C6: (1 - s)^7 (1 + 7s + 19s^2 + 21s^3) in 1D, (1 - s)^8 (1 + 8s + 25s^2 + 32s^3) in 2D and 3D.
template <int d>
struct WendlandC6 : Kernel<WendlandC6<d>, d> {
    static constexpr std::string_view name = "wendland-c6";
    static constexpr double support = 2;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma = by_dimension<d>(55.0 / 64, 39 / (14 * pi), 1365 / (512 * pi));
    static constexpr bool line = d == 1;
    static constexpr int n = line ? 7 : 8;

    template <class T>
    static constexpr T w(const T& q) {
        const T s = 0.5 * q;
        return power<n>(positive_part(1.0 - s)) *
               (1.0 + s * (double(n) + s * ((line ? 19.0 : 25.0) + (line ? 21.0 : 32.0) * s)));
    }
    template <class T>
    static constexpr T f(const T& q) {
        const T s = 0.5 * q;
        return (line ? -4.5 : -5.5) * power<n - 1>(positive_part(1.0 - s)) *
               (1.0 + s * ((line ? 6.0 : 7.0) + (line ? 35.0 / 3 : 16.0) * s));
    }
    template <class T>
    static constexpr T d2w(const T& q) {
        const T s = 0.5 * q;
        return (line ? -4.5 : -5.5) * power<n - 2>(positive_part(1.0 - s)) *
               (1.0 + s * ((line ? 5.0 : 6.0) - s * ((line ? 13.0 : 15.0) + (line ? 105.0 : 160.0) * s)));
    }
};

}  // namespace sph
