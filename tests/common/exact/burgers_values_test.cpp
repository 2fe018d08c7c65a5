#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "common/exact/burgers.hpp"
#include "tests/common/exact/burgers_reference.hpp"

using exact::Burgers;
using std::numbers::pi;

namespace {

double u(double viscosity, double time, double x) {
    return Burgers{viscosity}.velocity(x, time);
}

std::string message_of(double viscosity, double time, double x) {
    try {
        u(viscosity, time, x);
    } catch (const std::domain_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

// Relative error, measured: 2.2e-15; 5.6e-15 with all 330 rows of the table that this is a part of. Broken by
// 4 nu t -> nu t (error 1.1), 2 pi nu -> pi nu in the initial phi (1.1), half the range (0.08), a step 1.5
// times as wide (2e-9).
TEST_CASE("Burgers: the values of a table to 15 digits") {
    for (const auto& row : burgers_reference::ordinary) {
        CAPTURE(row.viscosity, row.time, row.x);
        CHECK(u(row.viscosity, row.time, row.x) == Approx(row.u).epsilon(2e-14).margin(0));
    }
}

// Relative error, measured: 7.4e-15; at nu = 1e-4, where exponents of 3000 are rounded, 1.9e-13. Over 19,850
// random values of the same kind: 3.5e-14 and 1.6e-13, and 1.8e-15 absolute. Broken by 1 - exp for expm1
// (error 1), a node at 0 of full weight (0.2), exp(-36) counted as negligible (1.2e-13), the series from nu t
// = 0.05 on (2e-9) or with five terms (4.3e-14), its exponent in double precision (5.7e-14), the sine taken
// for u while it is still within 1e-13 (9e-14).
TEST_CASE("Burgers: tiny and steep values keep their digits") {
    for (const auto& row : burgers_reference::corners) {
        CAPTURE(row.viscosity, row.time, row.x);
        const double tolerance = row.viscosity < 1e-3 ? 5e-13 : 4e-14;
        CHECK(u(row.viscosity, row.time, row.x) == Approx(row.u).epsilon(tolerance).margin(0));
    }
}

// Exact by construction: no tolerance. Dyadic x, so that x + 2 is exact. Broken by dropping the sign, and by
// fmod for remainder.
TEST_CASE("Burgers: odd, of period 2, zero at integers") {
    for (const double viscosity : {1e-3, 1e-2, 0.1, 1.0, 10.0}) {
        for (const double time : {0.0, 1e-6, 0.05, 0.5, 5.0}) {
            const Burgers solution{viscosity};
            CAPTURE(viscosity, time);
            for (const double x : {0.0625, 0.40625, 0.5, 0.71875, 0.9990234375}) {
                const double value = solution.velocity(x, time);
                CHECK(value > 0);
                CHECK(value <= 1);
                CHECK(solution.velocity(-x, time) == -value);
                CHECK(solution.velocity(2 - x, time) == -value);
                CHECK(solution.velocity(x + 2, time) == value);
                CHECK(solution.velocity(x - 1024, time) == value);
            }
            for (const double zero : {0.0, 1.0, -1.0, 2.0, -7.0, 1e15, 1e300})
                CHECK(solution.velocity(zero, time) == 0);
        }
    }
}

// Rounding only. sin(pi / 10) = (sqrt(5) - 1) / 4. Broken by sin(pi x) without the fold: 5e-5 at 1 - 2^-40.
TEST_CASE("Burgers: at t = 0 the sine") {
    for (const double viscosity : {1e-4, 1e-2, 1.0, 100.0}) {
        CHECK(u(viscosity, 0, 0.5) == 1);
        CHECK(u(viscosity, 0, 0.1) == Approx((std::sqrt(5.0) - 1) / 4).epsilon(1e-15).margin(0));
        CHECK(u(viscosity, 0, 0x1p-40) == Approx(pi * 0x1p-40).epsilon(1e-15).margin(0));
        CHECK(u(viscosity, 0, 1 - 0x1p-40) == Approx(pi * 0x1p-40).epsilon(1e-15).margin(0));
        CHECK(u(viscosity, 0, 1.25) == Approx(-std::sqrt(0.5)).epsilon(1e-15).margin(0));
    }
}

// On both sides of each change of method. Measured: 1.0e-14 at nu t = 0.1, 1.1e-15 at x = 1/2, 4.4e-16 at the
// first time that changes u. Broken by four terms in the series, or a step of the quadrature 1.5 times as
// wide.
TEST_CASE("Burgers: no step where the method changes") {
    for (const double viscosity : {2e-3, 1e-2, 3e-2, 0.1, 1.0, 10.0}) {
        CAPTURE(viscosity);
        const double change = 0.1 / viscosity;
        for (int k = 1; k < 200; ++k) {
            const double x = k / 200.0;
            const double before = u(viscosity, change * (1 - 4e-16), x);
            const double after = u(viscosity, change * (1 + 4e-16), x);
            CHECK(after == Approx(before).epsilon(5e-14).margin(0));
        }
        for (const double time : {1e-9, 0.01, 0.3, 0.5, 1.0, 5.0}) {
            const double left = u(viscosity, time, 0.5);
            const double right = u(viscosity, time, 0.5 + 0x1p-53);
            CHECK(right == Approx(left).epsilon(1e-13).margin(0));
        }
        const double first = 0.1 * std::numeric_limits<double>::epsilon() / (pi + viscosity * pi * pi);
        for (const double x : {1e-9, 0.3, 0.5, 0.8, 1 - 0x1p-30}) {
            const double after = u(viscosity, first * 1.0001, x);
            CHECK(after == Approx(u(viscosity, first * 0.9999, x)).epsilon(5e-14).margin(0));
        }
    }
}

// Fails for every check that is left out, and for a comparison that lets NaN pass.
TEST_CASE("Burgers: what lies outside the range is named") {
    CHECK_THAT(message_of(1e-5, 1, 0.5), Catch::Contains("viscosity") && Catch::Contains("= 1e-05 "));
    CHECK_THAT(message_of(101, 1, 0.5), Catch::Contains("viscosity = 101"));
    CHECK_THAT(message_of(0, 1, 0.5), Catch::Contains("viscosity = 0"));
    CHECK_THAT(message_of(std::nan(""), 1, 0.5), Catch::Contains("viscosity"));
    CHECK_THAT(message_of(1, -1, 0.5), Catch::Contains("time = -1"));
    CHECK_THAT(message_of(1, 100.5, 0.5), Catch::Contains("time = 100.5"));
    CHECK_THAT(message_of(1, std::nan(""), 0.5), Catch::Contains("time"));
    CHECK_THAT(message_of(1, 1, std::numeric_limits<double>::infinity()), Catch::Contains("x = inf"));
    CHECK(message_of(1e-4, 100, 0.5).empty());
    CHECK(message_of(100, 0, -1e300).empty());
}
