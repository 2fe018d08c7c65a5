// The family of estimates: exactness, orders, what it is a part of, and neighbourhoods that determine
// nothing.
#include <catch2/catch.hpp>

#include "chapters/02_consistency/scenes/cloud.hpp"
#include "chapters/06_finite_particle_method/scenes/estimators.hpp"
#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "common/report/norms.hpp"

using namespace sph;
using namespace sph::fpm;
using consistency::Where;

namespace {

ParticleSet points(Arrangement arrangement, std::size_t per_side, double h_over_dx, unsigned long seed = 1) {
    ParticleSet set;
    set.arrangement = arrangement, set.per_side = per_side, set.h_over_dx = h_over_dx;
    set.jitter = 0.3, set.seed = seed;
    return set;
}

/// Fitted orders of value, slope and curvature of the plane wave on jittered points.
template <int d>
std::array<double, 3> orders(const Choice& choice, const std::vector<std::size_t>& sizes, double h_over_dx,
                             std::size_t seeds, Where where) {
    std::array<std::vector<double>, 3> error;
    std::vector<double> n;
    for (const std::size_t size : sizes) {
        std::array<double, 3> mean{};
        for (std::size_t s = 1; s <= seeds; ++s) {
            const auto one =
                interpolate<d>(points(Arrangement::jittered, size, h_over_dx, s), plane_wave<d>, choice);
            for (std::size_t k = 0; k < 3; ++k)
                mean[k] += one.error(static_cast<int>(k), where) / static_cast<double>(seeds);
        }
        n.push_back(static_cast<double>(size));
        for (std::size_t k = 0; k < 3; ++k) error[k].push_back(mean[k]);
    }
    return {report::fitted_order(n, error[0]), report::fitted_order(n, error[1]),
            report::fitted_order(n, error[2])};
}

template <int d>
void check_exact(const std::string& member, std::size_t per_side, double bound) {
    const auto one = interpolate<d>(points(Arrangement::jittered, per_side, 1.4), parabola<d>, {member, 2});
    INFO(member << " in " << d << " dimensions");
    for (int degree = 0; degree <= 2; ++degree) CHECK(one.error(degree, Where::everywhere) < bound);
}

}  // namespace

TEST_CASE("Taylor's terms: their number, their factorials, their order") {
    CHECK((Taylor<1, 1>::count == 2 && Taylor<2, 1>::count == 3 && Taylor<3, 1>::count == 4));
    CHECK((Taylor<1, 2>::count == 3 && Taylor<2, 2>::count == 6 && Taylor<3, 2>::count == 10));
    const auto p = Taylor<2, 2>::at(Vector<2>{2.0, 3.0});
    CHECK(p == std::array<double, 6>{1, 2, 3, 4, 6, 9});
    CHECK((Taylor<2, 2>::terms[3].factorial == 2 && Taylor<2, 2>::terms[4].factorial == 1));
    CHECK(Taylor<1, 4>::terms[4].factorial == 24);
}

TEST_CASE("two bases, one consistency: FPM and SFPM are exact for quadratics, wherever the particles are") {
    // Measured: 4e-13 (1D), 5e-14, 1e-13 (3D). Fails with 1/2 missing before the curvature (Ye et al. 2019,
    // 14, as printed), or if a function of the basis is another one.
    for (const char* member : {"fpm", "sfpm", "taylor", "mls"}) {
        check_exact<1>(member, 200, 1e-10);
        check_exact<2>(member, 16, 1e-11);
        check_exact<3>(member, 8, 1e-11);
    }
    const auto random = interpolate<1>(points(Arrangement::random, 1000, 1), parabola<1>, {"fpm", 2});
    // Measured: 1.6e-8, rounding times the largest condition number.
    CHECK(random.error(1, Where::everywhere) < 1e-7);
    CHECK(random.enlarged.flagged > 0);  // measured: 18
    CHECK(random.enlarged.left == 0);
}

TEST_CASE("CSPM is exact for less: a constant's value, a line's slope") {
    const auto set = points(Arrangement::jittered, 200, 1.2);
    const auto line = interpolate<1>(set,
                                     [](const Vector<1>& x, std::size_t k) {
                                         return k == 0 ? 2 + 3 * x[0] : k == 1 ? 3.0 : 0.0;
                                     },
                                     {"cspm", 2});
    CHECK(line.error(1, Where::everywhere) < 1e-12);  // measured: 2e-14
    CHECK(line.error(0, Where::everywhere) > 1e-4);   // measured: 6e-4
    const auto parabolic = interpolate<1>(set, parabola<1>, {"cspm", 2});
    CHECK(parabolic.error(1, Where::everywhere) > 1e-4);  // measured: 1e-3
}

TEST_CASE("orders on jittered particles: value 3, slope 2, curvature between 1 and 2") {
    // Measured (1D): FPM 3.01, 1.99, 1.41; SFPM 2.99, 1.99, 1.41: at the ends the curvature is of order one,
    // inside of one and a half. Fails if volumes are left out of a matrix but not of its right-hand side.
    for (const char* member : {"fpm", "sfpm"}) {
        INFO(member);
        const auto found = orders<1>({member, 2}, {50, 100, 200, 400, 800}, 1.2, 8, Where::everywhere);
        CHECK(found[0] == Approx(3).margin(0.15));
        CHECK(found[1] == Approx(2).margin(0.1));
        CHECK((found[2] > 1 && found[2] < 1.7));
        const auto plane = orders<2>({member, 2}, {16, 32, 64, 128}, 1.6, 1, Where::everywhere);
        CHECK(plane[0] == Approx(3.3).margin(0.3));  // measured: 3.38, 3.31
        CHECK(plane[1] == Approx(1.93).margin(0.1));
        CHECK((plane[2] > 1 && plane[2] < 1.8));  // measured: 1.52
    }
    const auto cspm = orders<1>({"cspm", 2}, {50, 100, 200, 400, 800}, 1.2, 8, Where::inside);
    CHECK(cspm[0] == Approx(1.1).margin(0.3));
    CHECK(cspm[1] == Approx(1.0).margin(0.3));
    CHECK(cspm[2] < 0.3);  // does not converge
    const auto fourth = orders<1>({"sfpm", 4}, {50, 100, 200, 400}, 1.4, 8, Where::everywhere);
    CHECK(fourth[1] == Approx(4).margin(0.2));  // measured: 4.03
}

TEST_CASE("in space the slope is of second order, too") {
    const auto found = orders<3>({"sfpm", 2}, {8, 16, 32}, 1.4, 1, Where::everywhere);
    CHECK(found[1] == Approx(1.76).margin(0.1));
    CHECK(found[0] > 2.8);  // measured: 3.38
    // 1.76 is no order but the range: terms of higher order are not small at |k| h = 1.4 (8 points a side),
    // and nine tenths of 16^3 particles, six tenths of 32^3 have a support that a face cuts, where errors are
    // smaller. A wave that is twice as long, away from the faces (measured: 1.99; fails for a slope of first
    // order):
    std::array<double, 2> error{};
    for (const std::size_t finer : {0U, 1U})
        error[finer] = interpolate<3>(points(Arrangement::jittered, finer == 0 ? 16 : 32, 1.4),
                                      wave_of<3>(0.5), {"sfpm", 2})
                           .error_within(0.27);
    CHECK(std::log2(error[0] / error[1]) == Approx(1.99).margin(0.03));
}

TEST_CASE("first-order SFPM is chapter 2's fitted line") {
    // To rounding, value and slope: the same least squares. Fails for any other weight.
    ParticleSet set = points(Arrangement::jittered, 100, 1.2);
    const auto one = interpolate<1>(set, plane_wave<1>, {"sfpm", 1});
    const consistency::Function<1> wave{[](const Vector<1>& x) { return plane_wave<1>(x, 0); }, {}};
    auto cloud = consistency::cloud_of<1, LinearFit<>>(set, wave);
    const auto& line = cloud.estimate();
    for (std::size_t i = 0; i < 100; ++i) {
        CHECK(one.estimated[0][i] == Approx(line.fit[0][i]).margin(1e-12));  // measured: 2e-15
        CHECK(one.estimated[1][i] == Approx(line.fit[1][i]).margin(1e-10));  // measured: 5e-13
    }
}

TEST_CASE("CSPM's rows are chapter 2's") {
    ParticleSet set = points(Arrangement::jittered, 100, 1.2);
    const auto one = interpolate<1>(set, plane_wave<1>, {"cspm", 2});
    const consistency::Function<1> wave{[](const Vector<1>& x) { return plane_wave<1>(x, 0); }, {}};
    const consistency::Curvature curvature = consistency::cspm_curvature(set, wave);
    for (std::size_t i = 0; i < 100; ++i)
        CHECK(one.estimated[2][i] == Approx(curvature.value[i]).margin(1e-9));  // measured: 2e-11
}

TEST_CASE("a million random neighbourhoods: none is left singular, and the slope is right in all") {
    // Measured: 19,600 flagged (2 %), 0 left; slope 1.4e-5. Fails without enlarging: then the slope is noise.
    for (const double h_over_dx : {1.0, 1.5, 3.0}) {
        const Neighbourhoods found =
            random_neighbourhoods(h_over_dx == 1 ? 1000 : 100, 1000, h_over_dx, {"sfpm", 2}, "quintic", 7);
        INFO(h_over_dx << ": " << found.enlarged.flagged << " flagged");
        CHECK(found.enlarged.left == 0);
        CHECK(found.enlarged.worst_condition <= Estimates<1>::largest_condition);
        CHECK(found.slope_error < 2e-4);
        if (h_over_dx == 1) CHECK((found.enlarged.flagged > 10000 && found.enlarged.flagged < 40000));
    }
    std::vector<double> n, error;
    for (const std::size_t size : {250U, 500U, 1000U, 2000U}) {
        n.push_back(static_cast<double>(size));
        error.push_back(random_neighbourhoods(40, size, 1, {"sfpm", 2}, "quintic", 3).slope_error);
    }
    CHECK(report::fitted_order(n, error) == Approx(2).margin(0.3));
}

TEST_CASE("condition numbers: five on even particles, and what disorder makes of them") {
    // Measured: 5.0; jittered: 99 of 100 below 10; random: median 13, 99 of 100 at 2.2 dx below 115. Fails
    // with a matrix that is not in units of h.
    const auto conditions = [](Arrangement arrangement, double h_over_dx) {
        Column all =
            interpolate<1>(points(arrangement, 1000, h_over_dx), plane_wave<1>, {"sfpm", 2}).condition;
        std::sort(all.begin(), all.end());
        return all;
    };
    const Column even = conditions(Arrangement::even, 1), jittered = conditions(Arrangement::jittered, 1),
                 random = conditions(Arrangement::random, 1), wide = conditions(Arrangement::random, 2.2);
    CHECK(even[500] == Approx(5).margin(0.01));
    CHECK(jittered[990] < 20);
    CHECK(random[500] == Approx(13).margin(3));
    CHECK(random.back() > Estimates<1>::largest_condition);
    CHECK(wide[990] < 1000);
}

TEST_CASE("with too few particles for any fit, that is counted") {
    ParticleSet set = points(Arrangement::even, 2, 1);
    const auto two = interpolate<1>(set, parabola<1>, {"sfpm", 2});
    CHECK((two.enlarged.flagged == 2 && two.enlarged.left == 2));
}

TEST_CASE("members and orders that are not there are refused") {
    CHECK_THROWS_AS(estimator<1>("fpm", 3), std::invalid_argument);
    CHECK_THROWS_AS(estimator<2>("sfpm", 4), std::invalid_argument);
    CHECK_THROWS_AS(estimator<2>("brookshaw"), std::invalid_argument);
    CHECK_THROWS_AS(estimator<1>("fem"), std::invalid_argument);
    CHECK(members().size() == 7);
}
