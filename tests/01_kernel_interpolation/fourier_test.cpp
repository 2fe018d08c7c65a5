// Fourier transforms in closed form, and Poisson's formula for sums over even particles.
#include <catch2/catch.hpp>

#include "chapters/01_kernel_interpolation/fourier.hpp"
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"

using namespace sph;
using namespace sph::interpolation;

TEST_CASE("transforms agree with quadrature") {
    // Measured: 1.3e-13 at most (Wendland C6 just above the change of method at 2 kappa = 6), rounding
    // elsewhere. A lost factor of 2 in the argument 2 kappa of the Wendland kernels shows at 0.1.
    for_each_kernel<1>([](auto kernel) {
        using K = decltype(kernel);
        INFO(K::name);
        const Quadrature nodes = quadrature(kernel, 16);
        double worst = 0;
        const auto compare = [&](double kappa) {
            double sum = 0;
            for (std::size_t n = 0; n < nodes.q.size(); ++n) {
                sum += 2 * nodes.weight[n] * K::sigma * K::w(nodes.q[n]) * std::cos(kappa * nodes.q[n]);
            }
            worst = std::max(worst, std::abs(sum - transform(kernel, kappa)));
        };
        for (double kappa = 0; kappa < 30; kappa += 0.0731) compare(kappa);
        // Long waves, where sinc is a series: one with a wrong third term shows at 1e-12.
        for (const double kappa : {1e-3, 5e-3, 0.0199}) compare(kappa);
        CHECK(worst < 5e-13);
        CHECK(transform(kernel, 0.0) == Approx(1).epsilon(1e-14));
    });
}

TEST_CASE("the derivative of a transform is its derivative") {
    for_each_kernel<1>([](auto kernel) {
        INFO(kernel.name);
        for (const double kappa : {1e-3, 0.4, 1.7, 2.9, 3.1, 7.5, 12.0}) {
            constexpr double step = 1e-5;
            const double difference =
                (transform(kernel, kappa + step) - transform(kernel, kappa - step)) / (2 * step);
            CHECK(transform_derivative(kernel, kappa) == Approx(difference).margin(1e-8));
        }
    });
}

TEST_CASE("Gaussians have the same transform in every dimension") {
    CHECK(wave_error(Gaussian<2>{}, 0.7) == Approx(transform(Gaussian<2>{}, 0.7) - 1).epsilon(1e-12));
    CHECK(wave_error(Gaussian<3>{}, 0.7) == Approx(transform(Gaussian<3>{}, 0.7) - 1).epsilon(1e-12));
    CHECK(wave_error(SuperGaussian<2>{}, 0.7) ==
          Approx(transform(SuperGaussian<2>{}, 0.7) - 1).epsilon(1e-11));
    CHECK(wave_error(SuperGaussian<3>{}, 0.7) ==
          Approx(transform(SuperGaussian<3>{}, 0.7) - 1).epsilon(1e-11));
}

namespace {

/// dx sum_j W(x - x_j) for even particles, x at `offset` spacings from one of them (dx = 1).
template <class K>
double constant_sum(K, double h, double offset) {
    double sum = 0;
    const int reach = static_cast<int>(K::support * h) + 2;
    for (int j = -reach; j <= reach; ++j) sum += K::W(std::abs(offset - j), h);
    return sum;
}
template <class K>
double slope_sum(K, double h) {
    double sum = 0;
    const int reach = static_cast<int>(K::support * h) + 2;
    for (int j = -reach; j <= reach; ++j) sum -= std::abs(j) * K::dW_dr(double(std::abs(j)), h);
    return sum;
}

}  // namespace

TEST_CASE("sums over even particles follow Poisson's formula") {
    // Measured: 8.1e-15 for the constant, 4.5e-13 for the slope (super-Gaussian: the cut at 6h), over h/dx in
    // 0.8..2.5. The formula as printed (2.44, without the factor 2 of the sum) misses by half of the error.
    for_each_kernel<1>([](auto kernel) {
        INFO(kernel.name);
        double constant = 0, between = 0, slope = 0;
        for (double h = 0.8; h <= 2.5; h += 0.0173) {
            constant =
                std::max(constant, std::abs(constant_sum(kernel, h, 0) - 1 - constant_error(kernel, h)));
            between = std::max(between,
                               std::abs(constant_sum(kernel, h, 0.3) - 1 - constant_error(kernel, h, 0.3)));
            slope = std::max(slope, std::abs(slope_sum(kernel, h) - 1 - slope_error(kernel, h)));
        }
        CHECK(constant < 1e-12);
        CHECK(between < 1e-12);
        CHECK(slope < 1e-12);
    });
}

TEST_CASE("known values of the sums' errors") {
    // (2.41): 2 exp(-pi^2 h^2) + ...; (2.42): the cubic spline is exact at h = dx, and 1.8e-3 off at 1.2.
    CHECK(constant_error(Gaussian<1>{}, 1.0) == Approx(2 * std::exp(-pi * pi)).epsilon(1e-9));
    CHECK(std::abs(constant_error(CubicSpline<1>{}, 1.0)) < 1e-15);
    CHECK(constant_error(CubicSpline<1>{}, 1.2) == Approx(1.8e-3).epsilon(0.03));
    // Twice differentiated, a constant has a curvature: the sum of W'' over even particles.
    double curvature = 0;
    for (int j = -3; j <= 3; ++j) curvature += CubicSpline<1>::d2W_dr2(double(std::abs(j)), 1.2);
    CHECK(constant_curvature(CubicSpline<1>{}, 1.2) == Approx(curvature).epsilon(1e-4));
}
