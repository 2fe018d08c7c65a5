#pragma once
#include <vector>

#include "chapters/01_kernel_interpolation/kernels.hpp"

/// The integral interpolant (Monaghan 2005, 2.3), by Gauss-Legendre quadrature on the kernel's polynomial
/// pieces.
namespace sph::interpolation {

/// Nodes in [0, support] and weights of the integral over q, exact for polynomials of degree 31 on each piece
/// between the kernel's joints; `parts` >= 1 splits every piece further (for kernels and functions that are
/// no polynomials).
struct Quadrature {
    std::vector<double> q, weight;
};
Quadrature quadrature_over(double support, const std::vector<double>& joints, int parts);

template <class K>
Quadrature quadrature(K, int parts = 4) {
    return quadrature_over(K::support, {K::joints.begin(), K::joints.end()}, parts);
}

/// Surface of the unit sphere in d dimensions: 2, 2 pi, 4 pi.
template <int d>
constexpr double sphere_surface = by_dimension<d>(2, 2 * pi, 4 * pi);

/// The integral of W over all space: 1 if sigma is right.
template <class K>
double norm(K kernel) {
    const Quadrature nodes = quadrature(kernel);
    double sum = 0;
    for (std::size_t n = 0; n < nodes.q.size(); ++n) {
        const double q = nodes.q[n];
        sum += nodes.weight[n] * kernel.w(q) * to_dimension(K::dimension, q) / q;
    }
    return sphere_surface<K::dimension> * K::sigma * sum;
}

/// Second moment per axis over h^2: the integral of x^2 W. The leading error of the integral interpolant is
/// half of it times h^2 lap A (2.36, where it is called sigma).
template <class K>
double second_moment(K kernel) {
    const Quadrature nodes = quadrature(kernel);
    double sum = 0;
    for (std::size_t n = 0; n < nodes.q.size(); ++n) {
        const double q = nodes.q[n];
        sum += nodes.weight[n] * kernel.w(q) * to_dimension(K::dimension, q) * q;
    }
    return sphere_surface<K::dimension> * K::sigma * sum / K::dimension;
}

/// The mean of cos(k.x) over a sphere around the crest, kr = k r: cos in 1D, J_0 in 2D, sinc in 3D.
template <int d>
double wave_on_sphere(double kr) {
    if constexpr (d == 1) return std::cos(kr);
    if constexpr (d == 2) return std::cyl_bessel_j(0, kr);
    return kr < 1e-4 ? 1 - kr * kr / 6 : std::sin(kr) / kr;
}

/// Relative error of the integral interpolant of the plane wave cos(k.x) at its crest, kh = k h >= 0; for a
/// plane wave it is the same everywhere, and equal to the Fourier transform minus 1. Summed as the integral
/// of W (cos - 1), so that small errors keep their digits.
template <class K>
double wave_error(K kernel, double kh) {
    const Quadrature nodes = quadrature(kernel);
    double sum = 0;
    for (std::size_t n = 0; n < nodes.q.size(); ++n) {
        const double q = nodes.q[n];
        const double kr = kh * q;
        // 1 - the mean over the sphere, by its series where the difference would cancel.
        const double x = kr * kr / K::dimension;
        constexpr double d = K::dimension;
        const double deficit = kr < 0.1
                                   ? x / 2 * (1 - kr * kr / (4 * (d + 2)) * (1 - kr * kr / (6 * (d + 4))))
                                   : 1 - wave_on_sphere<K::dimension>(kr);
        sum += nodes.weight[n] * kernel.w(q) * to_dimension(K::dimension, q) / q * deficit;
    }
    return -sphere_surface<K::dimension> * K::sigma * sum;
}

/// The integral interpolant of A at x in 1D (2.3), h > 0.
template <class K, class Function>
double integral_interpolant(K kernel, Function&& A, double x, double h, const Quadrature& nodes) {
    static_assert(K::dimension == 1);
    double sum = 0;
    for (std::size_t n = 0; n < nodes.q.size(); ++n) {
        const double q = nodes.q[n];
        sum += nodes.weight[n] * kernel.w(q) * (A(x - h * q) + A(x + h * q));
    }
    return K::sigma * sum;
}

}  // namespace sph::interpolation
