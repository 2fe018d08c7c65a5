#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"

/// The Gaussian and the super-Gaussian, cut off at cut * h.
///
/// At the default cut = 6 what is left out is exp(-36) = 2e-16 of the maximum. The usual cut of 3
/// saves half of the neighbours in 1D and seven eighths in 3D, and leaves a jump of exp(-9) = 1.2e-4 of the
/// maximum.
namespace sph {

/// exp(-q^2), sigma = pi^(-d/2) (Gingold & Monaghan 1977; Chen 2017, 53).
template <int d, int cut = 6>
struct Gaussian : Kernel<Gaussian<d, cut>, d> {
    static constexpr std::string_view name = cut == 6 ? "gaussian" : "gaussian cut at 3h";
    static constexpr double support = cut;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma =
        by_dimension<d>(std::numbers::inv_sqrtpi, 1 / pi, std::numbers::inv_sqrtpi / pi);

    template <class T>
    static T w(const T& q) {
        using std::exp;
        return zero_beyond(support, q, exp(-q * q));
    }
    template <class T>
    static T f(const T& q) {
        return -2.0 * w(q);
    }
    template <class T>
    static T d2w(const T& q) {
        return (4.0 * q * q - 2.0) * w(q);
    }
};

/// (d/2 + 1 - q^2) exp(-q^2), sigma = pi^(-d/2): its second moment vanishes, so the integral interpolant is
/// of fourth order; the price is a negative ring around q^2 = d/2 + 2. (Monaghan 2005, 2.37, and Chen 2017,
/// 68, print the form for one dimension, 3/2 - q^2; in 2D that integrates to 1/2.)
template <int d, int cut = 6>
struct SuperGaussian : Kernel<SuperGaussian<d, cut>, d> {
    static constexpr std::string_view name = "super-gaussian";
    static constexpr double support = cut;
    static constexpr std::array<double, 0> joints{};
    static constexpr double sigma = Gaussian<d, cut>::sigma;

    template <class T>
    static T w(const T& q) {
        return (0.5 * d + 1.0 - q * q) * Gaussian<d, cut>::w(q);
    }
    template <class T>
    static T f(const T& q) {
        return (2.0 * q * q - (d + 4.0)) * Gaussian<d, cut>::w(q);
    }
    template <class T>
    static T d2w(const T& q) {
        const T q2 = q * q;
        return (q2 * (2.0 * d + 14.0 - 4.0 * q2) - (d + 4.0)) * Gaussian<d, cut>::w(q);
    }
};

}  // namespace sph
