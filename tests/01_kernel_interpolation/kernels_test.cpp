// One suite over all kernels in one, two and three dimensions. Bounds are those of double precision: eps
// = 2.2e-16.
#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "chapters/01_kernel_interpolation/scenes/naive.hpp"
#include "tests/01_kernel_interpolation/kernel_shapes.hpp"

using namespace sph;
using shapes::Complex;
using shapes::Shape;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Calls check(kernel) for every kernel in every dimension.
template <class Check>
void for_all(Check&& check) {
    for (const Shape& kernel : shapes::all()) {
        INFO(kernel.title());
        check(kernel);
    }
}

/// q from 0 to just inside the support, never on a joint.
std::vector<double> inside(const Shape& kernel) {
    std::vector<double> q;
    for (int n = 0; n < 2000; ++n) q.push_back(kernel.support * (n + 0.137) / 2000.5);
    return q;
}

/// The derivative of a function of one variable by complex step: exact to rounding.
template <class F>
double derivative(F&& f, double x) {
    constexpr double step = 1e-40;
    return f(Complex{x, step}).imag() / step;
}

double largest(const std::vector<double>& q, double (*f)(double)) {
    double result = 0;
    for (const double x : q) result = std::max(result, std::abs(f(x)));
    return result;
}

}  // namespace

// Kernels of polynomials are constant expressions.
static_assert(CubicSpline<3>::w(0.0) == 4.0);
static_assert(CubicSpline<3>::f(0.0) == -12.0);
static_assert(QuinticSpline<2>::w(3.0) == 0.0);
static_assert(WendlandC6<3>::W(2.0, 1.0) == 0.0);

TEST_CASE("kernels are positive and fall with distance, except the super-Gaussian") {
    for_all([](const Shape& kernel) {
        bool positive = true, falling = true;
        for (const double q : inside(kernel)) {
            positive = positive && kernel.w(q) > 0;
            falling = falling && kernel.f(q) < 0;
        }
        CHECK(positive != kernel.is_super());
        CHECK(falling != kernel.is_super());
    });
}

TEST_CASE("derivatives agree with the complex step") {
    // Measured: 2.2e-15 of the maximum at most (quintic). A wrong coefficient of the innermost polynomial of
    // f shows at 1e-2.
    for_all([](const Shape& kernel) {
        const auto q = inside(kernel);
        const double scale_1 = largest(q, kernel.dw), scale_2 = largest(q, kernel.d2w);
        double first = 0, second = 0, by_h = 0, scale_h = 0;
        for (const double x : q) {
            first = std::max(first, std::abs(kernel.dw(x) - derivative(kernel.complex_w, x)));
            second = std::max(second, std::abs(kernel.d2w(x) - derivative(kernel.complex_dw, x)));
            constexpr double h = 0.7;
            const double r = h * x;
            const auto W = [&](Complex z) {
                return kernel.sigma / to_dimension(kernel.dimension, z) * kernel.complex_w(r / z);
            };
            const double exact = derivative(W, h);
            by_h = std::max(by_h, std::abs(kernel.dW_dh(r, h) - exact));
            scale_h = std::max(scale_h, std::abs(exact));
        }
        CHECK(first <= 1e-14 * scale_1);
        CHECK(second <= 1e-14 * scale_2);
        CHECK(by_h <= 1e-14 * scale_h);
    });
}

TEST_CASE("the gradient factor times r is the slope") {
    for_all([](const Shape& kernel) {
        constexpr double h = 1.3;
        const auto W = [&](Complex z) { return kernel.complex_W(z, h); };
        const auto dW_dr = [&](Complex z) { return kernel.complex_dW_dr(z, h); };
        for (const double r : {0.0, 0.3, 1.1, 1.9}) {
            CHECK(kernel.F(r, h) * r == Approx(kernel.dW_dr(r, h)).margin(1e-15));
            CHECK(kernel.dW_dr(r, h) == Approx(derivative(W, r)).margin(1e-15));
            CHECK(kernel.d2W_dr2(r, h) == Approx(derivative(dW_dr, r)).margin(1e-14));
        }
    });
}

TEST_CASE("pieces join smoothly") {
    // Values on both sides of every joint and of the edge differ by what the slope explains: w, w' and w''
    // are continuous; the last for all but the kernels whose edge is (1 - s)^2 in w' (Lucy and C2 in 1D: w'
    // and w only), and the quadratic spline, whose w'' is made of steps.
    for_all([](const Shape& kernel) {
        std::vector<double> joints = kernel.joints;
        joints.push_back(kernel.support);
        constexpr double step = 1e-9;
        for (const double joint : joints) {
            const double before = joint - step, behind = joint + step;
            CHECK(kernel.w(behind) - kernel.w(before) == Approx(0).margin(500 * step));
            CHECK(kernel.dw(behind) - kernel.dw(before) == Approx(0).margin(2000 * step));
            if (kernel.name != "quadratic")
                CHECK(kernel.d2w(behind) - kernel.d2w(before) == Approx(0).margin(5000 * step));
        }
    });
}

TEST_CASE("kernels vanish at the support and beyond") {
    for_all([](const Shape& kernel) {
        for (const double q : {kernel.support, kernel.support * 1.001, 2 * kernel.support, 1e30}) {
            CHECK(kernel.w(q) == 0);
            CHECK(kernel.f(q) == 0);
            CHECK(std::abs(kernel.d2w(q)) == 0);
        }
    });
}

TEST_CASE("tiles give what single numbers give") {
    // Differences come from fused multiply-adds and from the exponential: a few eps of the maximum. Fails for
    // a formula that tiles do not share, or a lane in another's place.
    for_all([](const Shape& kernel) {
        constexpr double h = 0.9;
        const std::array numbers{kernel.W, kernel.F, kernel.d2W_dr2, kernel.dW_dh};
        std::array<double, 4> worst{};  // over the value at the centre
        for (int n = 0; n < 100; ++n) {
            std::array<double, tile_width> r{};
            for (std::size_t lane = 0; lane < tile_width; ++lane)
                r[lane] = kernel.support * 1.05 * (n * double(tile_width) + double(lane)) / 800;
            const auto tiles = kernel.tiles(Tile::load(r.data()), h);
            for (std::size_t k = 0; k < 4; ++k) {
                const double scale = std::abs(numbers[k](0.0, h));
                for (std::size_t lane = 0; lane < tile_width; ++lane)
                    worst[k] = std::max(worst[k], std::abs(tiles[k][lane] - numbers[k](r[lane], h)) / scale);
            }
        }
        for (const double difference : worst) CHECK(difference <= 8 * eps);  // measured 4.7 eps at most
    });
}

TEST_CASE("hard case: coincident and nearly coincident particles") {
    // The naive F = w'(q)/q is NaN at q = 0 and wrong by eps/q close to it; the branch-free form is neither.
    CHECK(std::isnan(interpolation::PiecewiseCubic<3>::f(0.0)));
    double naive = 0, ours = 0;
    for (double q = 1e-12; q < 0.5; q *= 1.37) {
        const double exact = 9 * q - 12;  // w'/q of the inner piece
        naive = std::max(naive, std::abs(interpolation::PiecewiseCubic<3>::f(q) - exact) / 12);
        ours = std::max(ours, std::abs(CubicSpline<3>::f(q) - exact) / 12);
    }
    CHECK(naive > 1e-5);     // measured 2.1e-4
    CHECK(ours <= 4 * eps);  // measured 3.0e-16
    for_all([](const Shape& kernel) {
        CHECK(std::isfinite(kernel.F(0.0, 1.0)));
        CHECK(kernel.F(0.0, 1.0) == Approx(kernel.d2W_dr2(0.0, 1.0)));  // w'/q -> w'' at q = 0
        CHECK(kernel.F(0.0, 1.0) < 0);
        CHECK(kernel.dW_dr(0.0, 1.0) == 0);
    });
    // Elsewhere the two agree: it is the same kernel.
    for (double q = 0.1; q < 2.2; q += 0.01) {
        CHECK(interpolation::PiecewiseCubic<2>::W(q, 1.0) == Approx(CubicSpline<2>::W(q, 1.0)).margin(1e-15));
        CHECK(interpolation::PiecewiseCubic<2>::F(q, 1.0) == Approx(CubicSpline<2>::F(q, 1.0)).margin(1e-13));
    }
}

TEST_CASE("kernels are found by the names that options accept") {
    CHECK(kernel_names() == std::vector<std::string>{"gaussian", "super-gaussian", "cubic", "quartic",
                                                     "quintic", "lucy", "wendland-c2", "wendland-c4",
                                                     "wendland-c6"});
    double support = 0;
    CHECK(with_kernel<3>("quartic", [&](auto kernel) { support = kernel.support; }));
    CHECK(support == 2.5);
    CHECK_FALSE(with_kernel<3>("quartics", [](auto) {}));
}
