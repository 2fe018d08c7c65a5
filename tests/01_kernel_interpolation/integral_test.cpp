// Integrals of all kernels in one, two and three dimensions: normalisation, moments, the smoothing error.
// Bounds are those of double precision: eps = 2.2e-16.
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>

using namespace sph;
using namespace sph::interpolation;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The integrals of one kernel.
struct Integrals {
    std::string name;
    int dimension = 1;
    double norm = 0, second_moment = 0;
    double (*wave_error)(double) = nullptr;
    bool is_super() const { return name == "super-gaussian"; }
    bool is_gaussian() const { return name.find("gaussian") != std::string::npos; }
};

/// Calls check(integrals) for every kernel in every dimension, and for the quadratic spline of chapter 4.
template <class Check>
void for_all(Check&& check) {
    const auto add = [&](const auto& kernel) {
        using K = std::decay_t<decltype(kernel)>;
        INFO(K::name << " in " << K::dimension << "D");
        check(Integrals{std::string{K::name}, K::dimension, norm(kernel), second_moment(kernel),
                        [](double kh) { return wave_error(K{}, kh); }});
    };
    for_each_kernel<1>(add);
    for_each_kernel<2>(add);
    for_each_kernel<3>(add);
    add(QuadraticSpline<1>{});
    add(QuadraticSpline<2>{});
    add(QuadraticSpline<3>{});
}

}  // namespace

TEST_CASE("kernels are normalised") {
    // Measured: 3.1 eps at most for the polynomials. The printed 15/(14 pi) of the cubic spline in 2D misses
    // by 2; 359 for 360 in any constant misses by 1e13 eps.
    const std::function<void(const Integrals&)> check = [](const Integrals& kernel) {
        // The Gaussians' quadrature is not exact; what is cut off at 6h is 5e-14 for the 3D super-Gaussian.
        CHECK(std::abs(kernel.norm - 1) <= (kernel.is_gaussian() ? 1e-13 : 4 * eps));
    };
    for_all(check);
}

TEST_CASE("the printed forms of two kernels are not normalised in 2D") {
    // Monaghan 2005: 15/(14 pi) for the cubic spline in 2D (after 2.6); the super-Gaussian (2.37), printed
    // for 1D, taken over to 2D as it stands.
    CHECK(norm(CubicSpline<2>{}) / CubicSpline<2>::sigma * 15 / (14 * pi) == Approx(3));
    const Quadrature nodes = quadrature(Gaussian<2>{});
    double printed = 0;
    for (std::size_t n = 0; n < nodes.q.size(); ++n) {
        const double q = nodes.q[n];
        printed += nodes.weight[n] * 2 * pi * q * (1.5 - q * q) * std::exp(-q * q) / pi;
    }
    CHECK(printed == Approx(0.5));
}

TEST_CASE("second moments have their exact values") {
    // Fractions by hand; a wrong piece of a spline shows here even if its norm were right.
    CHECK(second_moment(QuadraticSpline<1>{}) == Approx(0.25).epsilon(1e-14));
    CHECK(second_moment(CubicSpline<1>{}) == Approx(1.0 / 3).epsilon(1e-14));
    CHECK(second_moment(CubicSpline<2>{}) == Approx(31.0 / 98).epsilon(1e-14));
    CHECK(second_moment(CubicSpline<3>{}) == Approx(0.3).epsilon(1e-14));
    CHECK(second_moment(QuarticSpline<1>{}) == Approx(5.0 / 12).epsilon(1e-14));
    CHECK(second_moment(QuinticSpline<1>{}) == Approx(0.5).epsilon(1e-14));
    CHECK(second_moment(QuinticSpline<3>{}) == Approx(7.0 / 15).epsilon(1e-14));
    CHECK(second_moment(Lucy<3>{}) == Approx(1.0 / 3).epsilon(1e-14));
    CHECK(second_moment(WendlandC2<3>{}) == Approx(4.0 / 15).epsilon(1e-14));
    CHECK(second_moment(WendlandC4<1>{}) == Approx(4.0 / 15).epsilon(1e-14));
    CHECK(second_moment(WendlandC4<2>{}) == Approx(7.0 / 33).epsilon(1e-14));
    CHECK(second_moment(WendlandC6<1>{}) == Approx(8.0 / 39).epsilon(1e-14));
    CHECK(second_moment(WendlandC6<2>{}) == Approx(6.0 / 35).epsilon(1e-14));
    CHECK(std::abs(second_moment(SuperGaussian<1>{})) < 1e-12);
    CHECK(std::abs(second_moment(SuperGaussian<2>{})) < 1e-12);
    CHECK(std::abs(second_moment(SuperGaussian<3>{})) < 1e-12);  // measured 6.8e-13: the cut
}

TEST_CASE("kernels tend to the delta function") {
    // The integral of W cos(k.x) tends to 1 as h -> 0: second order, fourth for the super-Gaussian, in every
    // dimension. The printed super-Gaussian (3/2 for d/2 + 1) has order 0 in 2D and 3D.
    const std::function<void(const Integrals&)> check = [](const Integrals& kernel) {
        const double order = std::log2(kernel.wave_error(0.08) / kernel.wave_error(0.04));
        CHECK(std::abs(kernel.wave_error(1e-3)) < 1e-6);
        if (kernel.is_super()) {
            CHECK(order == Approx(4).margin(0.05));  // measured 3.9988
        } else {
            CHECK(order == Approx(2).margin(0.02));  // measured 1.9991 at the least
            // The leading term (2.36): -<x^2> k^2/2.
            CHECK(kernel.wave_error(0.01) == Approx(-kernel.second_moment * 0.5e-4).epsilon(1e-4));
        }
    };
    for_all(check);
}

TEST_CASE("the integral interpolant of any function is of second order, or fourth") {
    // A = exp(sin 2 pi x) at x = 0.3, 1D; between h = 0.01 and 0.005. A lost half of the support has order 0
    // or 1.
    for_each_kernel<1>([](const auto& kernel) {
        INFO(kernel.name);
        const auto A = [](double x) { return std::exp(std::sin(2 * pi * x)); };
        const Quadrature nodes = quadrature(kernel, 8);
        const double coarse = integral_interpolant(kernel, A, 0.3, 0.01, nodes) - A(0.3);
        const double fine = integral_interpolant(kernel, A, 0.3, 0.005, nodes) - A(0.3);
        const double expected = kernel.name == "super-gaussian" ? 4 : 2;
        CHECK(std::log2(coarse / fine) ==
              Approx(expected).margin(0.02));  // measured 3.996; 1.998 at the least
    });
}
