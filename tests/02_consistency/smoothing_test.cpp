// Jumps, and smoothing lengths that vary.
#include <catch2/catch.hpp>

#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "chapters/02_consistency/discontinuity.hpp"
#include "chapters/02_consistency/scenes/graded_line.hpp"
#include "chapters/02_consistency/smoothing_lengths.hpp"

using namespace sph;

TEST_CASE("DSPH is exact for a line with a jump, CSPM is not") {
    // Fails for a jump added with the wrong sign, a neighbour on the wrong side, or x_k and x_i mixed up.
    using K = QuinticSpline<1>;
    const std::size_t n = 60;
    const auto function = [](const Vector<1>& x) { return 1 + 2 * x[0] + (x[0] < 0.4 ? 0.0 : 5.0); };
    InterpolationWithin<K, Free, Value, DifferenceGradient, Shepard, MatrixGradient<>, BeyondJump,
                        DiscontinuousFit, OneSidedFit>
        cloud{Free{}, make_points<1>(Arrangement::jittered, n, 0.3, 6), 1.2 / n, function};
    const auto& known = cloud.particles();
    const Jump jump = Jump::find(0.4, known.x[0], known.A);
    CHECK(jump.x_left < 0.4);
    CHECK(jump.x_right >= 0.4);
    const auto& p = cloud.estimate(Effects{Value{}, DifferenceGradient{}, Shepard{}, MatrixGradient<>{},
                                           BeyondJump{jump}, DiscontinuousFit{jump}, OneSidedFit{}});
    double dsph = 0, one_sided = 0, cspm = 0, value = 0;
    for (std::size_t i = 0; i < n; ++i) {
        dsph = std::max(dsph, std::abs(p.dsph[1][i] - 2));
        one_sided = std::max(one_sided, std::abs(p.one_sided[1][i] - 2));
        cspm = std::max(cspm, std::abs(p.matrix[0][i] - 2));
        if (std::abs(p.x[0][i] - 0.4) < 0.1) value = std::max(value, std::abs(p.dsph[0][i] - p.A[i]));
    }
    CHECK(dsph < 1e-11);  // measured 3e-13
    CHECK(one_sided < 1e-11);
    CHECK(cspm > 100);    // measured 2e2
    CHECK(value < 0.05);  // CSPM's own error on a slope of 2; the jump is 5
    CHECK_THROWS_AS(Jump::find(2, known.x[0], known.A), std::invalid_argument);
}

namespace {

struct PairForce {
    using Reads = List<Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * (1 / i.rho + 1 / j.rho) * pair.F) * pair.x_ij;
    }
};

/// The total force over the sum of its sizes, for particles whose h follow their spacing.
template <class Smoothing>
double net_force(const Smoothing& smoothing, Support support) {
    const std::size_t n = 200;
    Particles<1, Position, Mass, Density, SmoothingLength, Acceleration> line{n};
    line.x[0] = GradedLine::positions(n);
    line.m.assign(n, 1.0 / n);
    Column reach;
    for (std::size_t i = 0; i < n; ++i) {
        line.h[i] = 1.2 / n / GradedLine::density(line.x[0][i]);
        reach.push_back(QuinticSpline<1>::support * line.h[i]);
    }
    Neighbours<1> neighbours;
    neighbours.find(line.x, reach, support);
    sum_over_neighbours(line, neighbours, smoothing, Effects{SummedDensity{}});
    sum_over_neighbours(line, neighbours, smoothing, Effects{PairForce{}});
    double total = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        total += line.m[i] * line.dv_dt[0][i];
        size += std::abs(line.m[i] * line.dv_dt[0][i]);
    }
    return std::abs(total) / size;
}

}  // namespace

TEST_CASE("symmetric kernels keep the momentum, each particle's own h does not") {
    // (60) and (61), with a symmetric search; a gather search alone loses pairs that one side does not see.
    using K = QuinticSpline<1>;
    CHECK(net_force(MeanH<K>{}, Support::symmetric) < 1e-13);       // measured 1e-16
    CHECK(net_force(MeanKernel<K>{}, Support::symmetric) < 1e-13);  // measured 1e-16
    CHECK(net_force(MeanKernel<K>{}, Support::gather) > 1e-4);
    CHECK(net_force(OwnH<K>{}, Support::gather) > 1e-3);  // measured 9e-3
}

TEST_CASE("with equal h all rules are the same kernel") {
    using K = CubicSpline<2>;
    Row<double, 2, SmoothingLength> i;
    i.h = 0.7;
    Row<Tile, 2, SmoothingLength> j;
    j.h.setConstant(0.7);
    Vec<Tile, 2> x_ij;
    for (int lane = 0; lane < 8; ++lane) {
        x_ij[0][lane] = 0.2 * lane;
        x_ij[1][lane] = 0.1;
    }
    const auto constant = ConstantH<K>{0.7}.pair(i, j, x_ij);
    const auto own = OwnH<K>{}.pair(i, j, x_ij);
    const auto mean = MeanH<K>{}.pair(i, j, x_ij);
    const auto kernels = MeanKernel<K>{}.pair(i, j, x_ij);
    for (const auto& [W, F] : {std::pair{own.W, own.F}, {mean.W, mean.F}, {kernels.W, kernels.F}}) {
        CHECK((W - constant.W).abs().maxCoeff() < 1e-15 * constant.W.maxCoeff());
        CHECK((F - constant.F).abs().maxCoeff() < 2e-15 * constant.F.abs().maxCoeff());
    }
    CHECK(constant.W[0] == Approx(K::W(0.1, 0.7)).epsilon(1e-14));
}

TEST_CASE("the mean-density smoothing length scales with the spacing") {
    // Chen 2017, (59), without the mass: h would not shrink with the number of particles.
    for (const std::size_t n : {std::size_t{100}, std::size_t{1000}}) {
        const Column rho(n, 1.0);
        const double m = 1.0 / static_cast<double>(n);
        CHECK(mean_density_h(rho, m, 1.2, 1) == Approx(1.2 * m));
        CHECK(mean_density_h(rho, m, 1.2, 2) == Approx(1.2 * std::sqrt(m)));
        CHECK(mean_density_h(rho, m, 1.2, 3) == Approx(1.2 * std::cbrt(m)));
    }
    CHECK(mean_density_h({1.0, 3.0}, 0.5, 1, 1) == Approx(0.25));  // the mean, not the first
}

TEST_CASE("the graded line: masses, density, ends") {
    // The density is the derivative of the mass, and the positions halve the masses.
    CHECK(GradedLine::mass_left_of(0) == Approx(0).margin(1e-14));
    const double dx = 1e-6;
    for (const double x : {0.1, 0.45, 0.5, 0.7}) {
        const double slope = (GradedLine::mass_left_of(x + dx) - GradedLine::mass_left_of(x - dx)) / (2 * dx);
        CHECK(slope / GradedLine::mass_left_of(1) == Approx(GradedLine::density(x)).epsilon(1e-8));
    }
    CHECK(GradedLine::density(1) / GradedLine::density(0) == Approx(10).epsilon(1e-6));
    const Column x = GradedLine::positions(4);
    CHECK(GradedLine::mass_left_of(x[1]) / GradedLine::mass_left_of(1) == Approx(0.375).epsilon(1e-12));
}
