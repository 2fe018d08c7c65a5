#include "common/report/norms.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

using report::fitted_order;
using report::l1_error;
using report::l2_error;
using report::linf_error;
using report::observed_order;
using Values = std::vector<double>;

TEST_CASE("norms of a known error") {
    // e = (1, 2, -4), f - e = (1, -1, 2). Fails if a norm is not relative, a square or root is missing, or
    // the sign of an exact value counts.
    const Values exact{1, 2, -4}, value{2, 1, -2};
    CHECK(l1_error(value, exact) == Approx(4.0 / 7).epsilon(1e-15));
    CHECK(l2_error(value, exact) == Approx(std::sqrt(6.0 / 21)).epsilon(1e-15));
    CHECK(linf_error(value, exact) == 0.5);
    CHECK(l1_error(exact, exact) == 0);
}

TEST_CASE("weights are the widths of the points") {
    // A point of width 2 counts as two of width 1. Fails if a weight is left out of error or scale.
    const Values exact{1, 2, 3}, value{1.5, 2, 4}, weight{2, 1, 1};
    const Values exact_twice{1, 1, 2, 3}, value_twice{1.5, 1.5, 2, 4};
    CHECK(l1_error(value, exact, weight) == Approx(l1_error(value_twice, exact_twice)).epsilon(1e-15));
    CHECK(l2_error(value, exact, weight) == Approx(l2_error(value_twice, exact_twice)).epsilon(1e-15));
}

TEST_CASE("a run that failed does not look exact") {
    // Fails if the largest value is taken with std::max, which drops NaN.
    const double nan = std::nan("");
    for (const Values& value : {Values{nan, 1}, Values{1, nan}}) {
        CHECK(std::isnan(l1_error(value, Values{1, 1})));
        CHECK(std::isnan(l2_error(value, Values{1, 1})));
        CHECK(std::isnan(linf_error(value, Values{1, 1})));
    }
}

TEST_CASE("norms refuse what has no meaning") {
    // Each line fails if its check is left out.
    const Values one{1}, two{1, 2}, zero{0, 0}, none;
    CHECK_THROWS_AS(l1_error(one, two), std::invalid_argument);
    CHECK_THROWS_AS(l2_error(two, one), std::invalid_argument);
    CHECK_THROWS_AS(linf_error(none, none), std::invalid_argument);
    CHECK_THROWS_AS(l1_error(two, zero), std::invalid_argument);
    CHECK_THROWS_AS(l1_error(two, two, one), std::invalid_argument);
}

TEST_CASE("errors of values that come one by one, vectors component by component") {
    // e = (1, 2, -4), f - e = (1, -1, 2), as above. Fails if a root is missing, or if errors are added
    // unsquared.
    report::SquaredError error;
    error.add(2, 1);
    error.add(1, 2);
    error.add(-2, -4);
    CHECK(error.relative() == Approx(std::sqrt(6.0 / 21)).epsilon(1e-15));
    report::SquaredError none;
    none.add(1, 0);
    CHECK_FALSE(std::isfinite(none.relative()));  // the exact values are all zero: there is no relative error
}

TEST_CASE("observed order") {
    // Errors 3 n^-2. Fails if the sign is turned or n1 and n2 are swapped.
    CHECK(observed_order(10, 0.03, 20, 0.0075) == Approx(2).epsilon(1e-14));
    CHECK(observed_order(20, 0.0075, 10, 0.03) == Approx(2).epsilon(1e-14));
    CHECK(observed_order(10, 1, 20, 2) == Approx(-1).epsilon(1e-14));
    CHECK_THROWS_AS(observed_order(10, 1, 10, 2), std::invalid_argument);
    CHECK_THROWS_AS(observed_order(10, 0, 20, 1), std::invalid_argument);
    CHECK_THROWS_AS(observed_order(10, 1, 20, std::nan("")), std::invalid_argument);
}

TEST_CASE("fitted order") {
    // Exact for a power; for (1, 1), (2, 1/2), (4, 1/8) in log2: y = 0, -1, -3, slope -3/2.
    // Fails if the means are not subtracted or the sign is turned.
    CHECK(fitted_order(Values{10, 20, 80}, Values{0.03, 0.0075, 0.00046875}) == Approx(2).epsilon(1e-13));
    CHECK(fitted_order(Values{1, 2, 4}, Values{1, 0.5, 0.125}) == Approx(1.5).epsilon(1e-13));
    CHECK_THROWS_AS(fitted_order(Values{1}, Values{1}), std::invalid_argument);
    CHECK_THROWS_AS(fitted_order(Values{1, 2}, Values{1}), std::invalid_argument);
    CHECK_THROWS_AS(fitted_order(Values{2, 2}, Values{1, 2}), std::invalid_argument);
    CHECK_THROWS_AS(fitted_order(Values{1, 2}, Values{1, -2}), std::invalid_argument);
}
