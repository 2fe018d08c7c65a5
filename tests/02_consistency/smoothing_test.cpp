// Jumps, and smoothing lengths that vary.
#include <catch2/catch.hpp>

#include <array>

#include "chapters/02_consistency/discontinuity.hpp"
#include "chapters/02_consistency/scenes/graded_line.hpp"
#include "chapters/02_consistency/scenes/jump_line.hpp"
#include "chapters/02_consistency/scenes/length_rules.hpp"
#include "chapters/02_consistency/smoothing_lengths.hpp"

using namespace sph;
using namespace sph::consistency;

TEST_CASE("DSPH is exact for a line with a jump, CSPM is not") {
    // Fails for a jump added with the wrong sign, a neighbour on the wrong side, or x_k and x_i mixed up.
    const Function<1> function{[](const Vector<1>& x) { return 1 + 2 * x[0] + (x[0] < 0.4 ? 0.0 : 5.0); },
                               [](const Vector<1>&) { return Vector<1>{2.0}; }};
    const JumpLine line = line_with_jump(function, 0.4, 60, 0.3, 6, 1);
    const auto worst_slope = [&](const std::string& name) {
        double worst = 0;
        for (const double slope : line.scheme(name).slope) worst = std::max(worst, std::abs(slope - 2));
        return worst;
    };
    CHECK(worst_slope("dsph") < 1e-11);       // measured 3e-13
    CHECK(worst_slope("one-sided") < 1e-11);  // measured 3e-13
    CHECK(worst_slope("cspm") > 100);         // measured 2e2
    double value = 0;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (std::abs(line.x[i] - 0.4) < 0.1)
            value = std::max(value, std::abs(line.scheme("dsph").value[i] - line.exact[i]));
    }
    CHECK(value < 0.05);  // CSPM's own error on a slope of 2; the jump is 5
    double one_sided = 0;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (std::abs(line.x[i] - 0.4) < 0.1)
            one_sided = std::max(one_sided, std::abs(line.scheme("one-sided").value[i] - line.exact[i]));
    }
    CHECK(one_sided < 0.05);  // fails if what is beyond is not taken out as A (V/A for V A)
    const Jump jump = Jump::find(0.4, line.x, line.exact);
    CHECK(jump.x_left < 0.4);
    CHECK(jump.x_right >= 0.4);
    CHECK_THROWS_AS(Jump::find(2, line.x, line.exact), std::invalid_argument);
    CHECK_THROWS_AS(line_with_jump(function, 2, 60, 0.3, 6, 1), std::invalid_argument);
}

TEST_CASE("symmetric kernels keep the momentum, each particle's own h does not") {
    // (60) and (61), with a symmetric search; a gather search alone loses pairs that one side does not see.
    const auto net_force = [](const std::string& name) {
        for (const LengthRule& rule : length_rules()) {
            if (rule.name == name) return rule.run(200).net_force;
        }
        throw std::out_of_range{name};
    };
    CHECK(net_force("mean-h") < 1e-13);       // measured 1e-16
    CHECK(net_force("mean-kernel") < 1e-13);  // measured 1e-16
    CHECK(run_mean_kernel(200, Support::gather).net_force > 1e-4);
    CHECK(net_force("own-h") > 1e-3);  // measured 9e-3
}

TEST_CASE("with equal h all rules are the same kernel") {
    using K = CubicSpline<2>;
    Row<double, 2, SmoothingLength> i;
    i.h = 0.7;
    Row<Tile, 2, SmoothingLength> j;
    j.h = 0.7;
    const std::array<double, tile_width> x{0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4};
    const Vec<Tile, 2> x_ij{Tile::load(x.data()), 0.1};
    const auto constant = ConstantH<K>{0.7}.pair(i, j, x_ij);
    const auto own = OwnH<K>{}.pair(i, j, x_ij);
    const auto mean = MeanH<K>{}.pair(i, j, x_ij);
    const auto kernels = MeanKernel<K>{}.pair(i, j, x_ij);
    for (const auto& [W, F] : {std::pair{own.W, own.F}, {mean.W, mean.F}, {kernels.W, kernels.F}}) {
        CHECK((W - constant.W).abs().maxCoeff() < 1e-15 * constant.W.maxCoeff());
        CHECK((F - constant.F).abs().maxCoeff() < 2e-15 * constant.F.abs().maxCoeff());
    }
    CHECK(constant.W[0] == Approx(K::W(0.1, 0.7)).epsilon(1e-14));
    j.h = 0.9;
    CHECK(MeanH<K>{}.pair(i, j, x_ij).h[0] == Approx(0.8));
    CHECK(MeanKernel<K>{}.pair(i, j, x_ij).h[0] == Approx(0.8));
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
