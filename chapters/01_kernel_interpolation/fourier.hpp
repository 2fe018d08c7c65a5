#pragma once
#include <complex>

#include "chapters/01_kernel_interpolation/kernels.hpp"

/// Fourier transforms of the kernels, and with them the exact errors of sums over even particles.
///
/// W^(kappa) is the integral of W(x, h) cos(k x) dx with kappa = k h: 1 at kappa = 0 for a normalised kernel.
/// T is double, or std::complex<double> for derivatives by complex step.
namespace sph {

/// sin(x)/x, by its series where the quotient loses digits.
template <class T>
T sinc(const T& x) {
    using std::abs, std::sin;
    if (abs(x) < 1e-2) {
        const T x2 = x * x;
        return 1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0));
    }
    return sin(x) / x;
}

/// M_n: sinc(kappa/2)^n (Monaghan 2005, 2.4, the definition of the splines).
template <class T>
T transform(CubicSpline<1>, const T& kappa) {
    return power<4>(sinc(0.5 * kappa));
}
template <class T>
T transform(QuarticSpline<1>, const T& kappa) {
    return power<5>(sinc(0.5 * kappa));
}
template <class T>
T transform(QuinticSpline<1>, const T& kappa) {
    return power<6>(sinc(0.5 * kappa));
}
/// exp(-kappa^2/4), in any dimension.
template <int d, int cut, class T>
T transform(Gaussian<d, cut>, const T& kappa) {
    using std::exp;
    return exp(-0.25 * kappa * kappa);
}
/// (1 + kappa^2/4) exp(-kappa^2/4) = 1 + O(kappa^4), in any dimension.
template <int d, int cut, class T>
T transform(SuperGaussian<d, cut>, const T& kappa) {
    return (1.0 + 0.25 * kappa * kappa) * transform(Gaussian<d, cut>{}, kappa);
}

/// A polynomial on 0 <= s <= 1, coefficient[n] of s^n.
template <std::size_t size>
using Polynomial = std::array<double, size>;

/// The polynomial (1 - s)^power * factor(s).
template <int power, std::size_t size>
constexpr auto edge_polynomial(const Polynomial<size>& factor) {
    Polynomial<size + power> result{};
    std::copy(factor.begin(), factor.end(), result.begin());
    for (int times = 0; times < power; ++times) {
        for (std::size_t n = result.size() - 1; n > 0; --n) result[n] -= result[n - 1];
    }
    return result;
}

/// 2 times the integral of p(s) cos(kappa s) over 0 <= s <= 1. For |kappa| > 6 in closed form, by repeated
/// integration by parts, p sin/kappa + p' cos/kappa^2 - p'' sin/kappa^3 - ...; below, where those terms
/// cancel, by the moments of p: sum_n (-1)^n kappa^(2n)/(2n)! M_2n. Absolute error below 1e-13.
template <class T, std::size_t size>
T cosine_transform(Polynomial<size> p, const T& kappa) {
    using std::abs, std::sin, std::cos;
    T sum = 0;
    if (abs(kappa) > 6) {
        const std::array<T, 4> at_one{sin(kappa), cos(kappa), -sin(kappa), -cos(kappa)};
        constexpr std::array at_zero{0.0, 1.0, 0.0, -1.0};
        T scale = 1.0 / kappa;
        for (std::size_t m = 0; m < size; ++m) {  // p is the m-th derivative here
            double end = 0;
            for (const double c : p) end += c;
            sum += scale * (end * at_one[m % 4] - p[0] * at_zero[m % 4]);
            for (std::size_t n = 1; n < size; ++n) p[n - 1] = static_cast<double>(n) * p[n];
            p[size - 1] = 0;
            scale /= kappa;
        }
        return 2.0 * sum;
    }
    T term = 1;
    for (int n = 0; n <= 24; ++n) {
        double moment = 0;
        for (std::size_t c = 0; c < size; ++c) moment += p[c] / (2.0 * n + static_cast<double>(c) + 1);
        sum += term * moment;
        term *= -kappa * kappa / ((2.0 * n + 1) * (2.0 * n + 2));
    }
    return 2.0 * sum;
}

/// Lucy and Wendland in 1D: support 2h, so s = q/2 and the argument is 2 kappa.
template <class T>
T transform(WendlandC2<1> kernel, const T& kappa) {
    return 2 * kernel.sigma * cosine_transform(edge_polynomial<3>(Polynomial<2>{1, 3}), 2.0 * kappa);
}
template <class T>
T transform(Lucy<1>, const T& kappa) {
    return transform(WendlandC2<1>{}, kappa);
}
template <class T>
T transform(WendlandC4<1> kernel, const T& kappa) {
    return 2 * kernel.sigma * cosine_transform(edge_polynomial<5>(Polynomial<3>{1, 5, 8}), 2.0 * kappa);
}
template <class T>
T transform(WendlandC6<1> kernel, const T& kappa) {
    return 2 * kernel.sigma * cosine_transform(edge_polynomial<7>(Polynomial<4>{1, 7, 19, 21}), 2.0 * kappa);
}

/// dW^/dkappa by complex step: exact to rounding, no difference is formed.
template <class K>
double transform_derivative(K kernel, double kappa) {
    constexpr double step = 1e-30;
    return transform(kernel, std::complex<double>{kappa, step}).imag() / step;
}

/// 2 sum_{r >= 1} term(2 pi r h/dx): the error that Poisson's summation formula gives for a sum over even
/// particles (Monaghan 2005, 2.38). The terms of the constant and the slope fall at least like r^-3 and are
/// summed until they are below rounding. Those of the curvature fall like r^-2 for the cubic spline, Lucy and
/// C2; there the sum is cut off at 40,000 terms and good to about 1e-5.
template <class Term>
double poisson_sum(double h_over_dx, Term&& term) {
    constexpr int most_terms = 40000;
    double sum = 0;
    int negligible = 0;
    for (int r = 1; r <= most_terms && negligible < 50; ++r) {
        const double t = 2 * term(2 * pi * r * h_over_dx);
        sum += t;
        negligible = std::abs(t) < 1e-18 ? negligible + 1 : 0;
    }
    return sum;
}

/// Relative error of a constant, dx sum_j W(x - x_j) - 1, on even particles; `offset` is the distance of x
/// from a particle in spacings (2.40-2.42; h_over_dx > 0).
template <class K>
double constant_error(K kernel, double h_over_dx, double offset = 0) {
    return poisson_sum(h_over_dx, [&](double kappa) {
        return transform(kernel, kappa) * std::cos(kappa / h_over_dx * offset);
    });
}
/// Relative error of the derivative (2.14) of a straight line at an even particle (2.43-2.44; in our copy the
/// lower limit of 2.43 is garbled and the factor 2 of 2.44, compare 2.40, is missing): -2 sum_r int q W'
/// cos(2 pi r q/dx) dq, and integration by parts turns each integral into -(W^ + kappa dW^/dkappa).
/// Brookshaw's second derivative of a parabola has exactly the same error: both are -dx sum_j x_j W'(x_j).
template <class K>
double slope_error(K kernel, double h_over_dx) {
    return poisson_sum(h_over_dx, [&](double kappa) {
        return transform(kernel, kappa) + kappa * transform_derivative(kernel, kappa);
    });
}
/// What the twice differentiated sum (2.21) gives for the second derivative of the constant 1, times dx^2:
/// -2 sum_r (2 pi r)^2 W^: it does not depend on dx, so the error grows like 1/dx^2.
template <class K>
double constant_curvature(K kernel, double h_over_dx) {
    return poisson_sum(h_over_dx,
                       [&](double kappa) { return -square(kappa / h_over_dx) * transform(kernel, kappa); });
}

}  // namespace sph
