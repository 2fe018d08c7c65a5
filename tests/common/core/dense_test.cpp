// Dense linear algebra: small tensors, and matrices with a row for each particle.
#include "common/core/dense.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace sph;

namespace {

class Entries {
  public:
    double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-52 - 1; }

  private:
    std::mt19937_64 bits_{3};
};

template <int d>
Tensor<d> random_symmetric(Entries& random) {
    Tensor<d> M{};
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t b = 0; b <= a; ++b) M[a][b] = M[b][a] = random();
    }
    return M;
}

template <int d>
Vector<d> times(const Tensor<d>& M, const Vector<d>& v) {
    Vector<d> result{};
    for (std::size_t a = 0; a < d; ++a) result[a] = dot(M[a], v);
    return result;
}

template <int d>
double largest_difference(const Vector<d>& a, const Vector<d>& b) {
    double worst = 0;
    for (std::size_t k = 0; k < d; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
    return worst;
}

/// The largest failure of M v = lambda v, of unit length, of order, and of the extreme eigenvalues.
template <int d>
double worst_of_axes() {
    Entries random;
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
        const Tensor<d> M = random_symmetric<d>(random);
        const Axes<d> axes = axes_of<d>(M);
        for (std::size_t a = 0; a < d; ++a) {
            worst = std::max(worst, largest_difference<d>(times<d>(M, axes.direction[a]),
                                                          axes.value[a] * axes.direction[a]));
            for (std::size_t b = 0; b < d; ++b) {
                const double product = dot(axes.direction[a], axes.direction[b]);
                worst = std::max(worst, std::abs(product - (a == b ? 1 : 0)));
            }
            if (a > 0) CHECK(axes.value[a] >= axes.value[a - 1]);
        }
        const Vector<2> ends = extreme_eigenvalues<d>(M);
        worst = std::max(worst, std::abs(ends[0] - axes.value[0]));
        worst = std::max(worst, std::abs(ends[1] - axes.value[d - 1]));
    }
    return worst;
}

/// The largest failure of M (M^-1 b) = b over the size of the solution.
template <int d>
double worst_of_inverse() {
    Entries random;
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
        Tensor<d> M{};
        Vector<d> b{};
        for (std::size_t a = 0; a < d; ++a) {
            b[a] = random();
            for (std::size_t c = 0; c < d; ++c) M[a][c] = random() + (a == c ? 3 : 0);
        }
        const Vector<d> x = inverse_times<d>(M, b);
        worst = std::max(worst, largest_difference<d>(times<d>(M, x), b));
    }
    return worst;
}

}  // namespace

TEST_CASE("axes of symmetric tensors: eigenvalues in order, unit vectors along them") {
    // Fails if rows and columns of the directions are exchanged, or a formula of the extreme ones has a sign
    // wrong.
    CHECK(worst_of_axes<1>() < 1e-15);
    CHECK(worst_of_axes<2>() < 5e-15);  // measured 7e-16
    CHECK(worst_of_axes<3>() < 1e-14);  // measured 1.3e-15
}

TEST_CASE("small systems, symmetric or not") {
    // Fails if the tensor is transposed on its way.
    CHECK(worst_of_inverse<1>() < 1e-15);
    CHECK(worst_of_inverse<2>() < 5e-15);                                      // measured 3e-16
    CHECK(worst_of_inverse<3>() < 5e-15);                                      // measured 4e-16
    CHECK_FALSE(std::isfinite(inverse_times<2>(Tensor<2>{}, {1.0, 0.0})[0]));  // whatever M is
}

TEST_CASE("large systems by elimination with pivots") {
    // A zero on the diagonal needs a pivot. Fails without one, or if rows and columns are exchanged.
    Entries random;
    const std::size_t n = 60;
    Dense M{n};
    Column exact(n), b(n);
    for (std::size_t i = 0; i < n; ++i) exact[i] = random();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            M(i, j) = i == j ? 0 : random();
            b[i] += M(i, j) * exact[j];
        }
    }
    const Column x = solve(M, b);
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) worst = std::max(worst, std::abs(x[i] - exact[i]));
    CHECK(worst < 1e-11);  // measured 1.4e-14
    CHECK(M.size() == n);
    CHECK_THROWS_AS(solve(Dense{3}, Column{1, 2, 3}), std::runtime_error);  // singular
}

TEST_CASE("a matrix gives back what was written, to those who only read too") {
    Dense M{3};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) M(i, j) = static_cast<double>(10 * i + j);
    }
    const Dense& read = M;
    CHECK(read(2, 1) == 21);  // fails for row / n
    CHECK(read(1, 2) == 12);
    CHECK(M.data()[5] == 12);  // row by row
}

TEST_CASE("eigenvalues of any matrix") {
    // Of (z - 2)(z^2 + 1)(z + 3), by the companion matrix: two real ones and a pair. Fails for a transposed
    // or half-read matrix.
    const double c0 = -6, c1 = 1, c2 = -5, c3 = 1;  // z^4 + c3 z^3 + c2 z^2 + c1 z + c0
    Dense M{4};
    for (std::size_t k = 0; k < 3; ++k) M(k, k + 1) = 1;
    M(3, 0) = -c0;
    M(3, 1) = -c1;
    M(3, 2) = -c2;
    M(3, 3) = -c3;
    auto values = eigenvalues(M);
    REQUIRE(values.size() == 4);
    for (const auto& exact : std::vector<std::complex<double>>{{2, 0}, {-3, 0}, {0, 1}, {0, -1}}) {
        double nearest = 1;
        for (const auto& value : values) nearest = std::min(nearest, std::abs(value - exact));
        INFO(exact);
        CHECK(nearest < 1e-12);  // measured 6e-15
    }
    CHECK(eigenvalues(Dense{0}).empty());
}
