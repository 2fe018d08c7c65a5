#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "common/exact/toy_star_modes.hpp"
#include "tests/common/exact/derivatives.hpp"
#include "tests/common/exact/toy_star_reference.hpp"

using exact::toy_star_density;
using exact::toy_star_frequency;
using exact::toy_star_velocity;

namespace {

std::string message_of(const auto& call) {
    try {
        call();
    } catch (const std::domain_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

// Relative error, measured: 2.2e-16. Broken by gamma j -> j, by j(j-1) -> j^2, and by degree = mode.
TEST_CASE("toy star: the frequencies of a table") {
    for (int j = 0; j < 1000; ++j) {
        CAPTURE(j);
        const double expected = std::sqrt((j + 1.0) * (j + 2.0) / 2);  // gamma = 2: waves in shallow water
        CHECK(toy_star_frequency(2, j + 1) == Approx(expected).epsilon(1e-15).margin(0));
    }
    CHECK(toy_star_frequency(2, 20) == Approx(14.49137674618944).epsilon(1e-15).margin(0));
    CHECK(toy_star_frequency(1.4, 2) == Approx(1.54919333848296673).epsilon(1e-15).margin(0));
    CHECK(toy_star_frequency(1.4, 5) == Approx(3).epsilon(1e-15).margin(0));
    CHECK(toy_star_frequency(5.0 / 3, 20) == Approx(12.1106014163899672).epsilon(1e-15).margin(0));
    CHECK(toy_star_frequency(1.1, 10) == Approx(3.80788655293195467).epsilon(1e-15).margin(0));
    CHECK(toy_star_frequency(100, 1000) == Approx(7032.17605012843802).epsilon(1e-15).margin(0));
    for (const double gamma : {1.001, 1.4, 3.0, 100.0}) CHECK(toy_star_frequency(gamma, 1) == 1);
}

// Decides eigenfunction and frequency together, without any table: residual over the terms' magnitudes.
// Measured: 6.1e-10, rounding in the second difference where the polynomial is small. Broken by another
// frequency, by lambda + 1/(gamma-1) for lambda, by a lost factor 2 or a wrong sign in the recurrence.
TEST_CASE("toy star: eigenfunction and frequency obey the wave equation of the star") {
    double worst = 0;
    for (const double gamma : {1.2, 1.4, 5.0 / 3, 2.0, 3.0, 7.0}) {
        for (const int mode : {1, 2, 3, 4, 7, 12, 20}) {
            for (const double x : {-0.8, -0.3, 0.05, 0.4, 0.77, 0.9}) {
                CAPTURE(gamma, mode, x);
                const double h = 0.1 / (mode + 5);
                const auto [dv_dx, d2v_dx2] = finite_difference::derivatives(
                    h, [&](double s) { return toy_star_velocity(gamma, mode, x + s); });
                const double omega = toy_star_frequency(gamma, mode);
                const double stretching = (gamma - 1) / 2 * (1 - x * x) * d2v_dx2;
                const double advection = gamma * x * dv_dx;
                const double inertia = (omega * omega - 1) * toy_star_velocity(gamma, mode, x);
                const double scale = std::fabs(stretching) + std::fabs(advection) + std::fabs(inertia) + 1e-3;
                worst = std::max(worst, std::fabs(stretching - advection + inertia) / scale);
            }
        }
    }
    CHECK(worst < 5e-9);
}

// Absolute error, measured: 1.7e-16. Broken by the same, by the parity of mode for that of degree, and by the
// recurrence for y_j itself, which is wrong by 4e-12 in mode 1000.
TEST_CASE("toy star: the eigenfunctions of a table") {
    double worst = 0;
    for (const auto& row : toy_star_reference::eigenfunctions) {
        CAPTURE(row.gamma, row.mode, row.x);
        worst = std::max(worst, std::fabs(toy_star_velocity(row.gamma, row.mode, row.x) - row.value));
    }
    CHECK(worst < 2e-15);
}

// Exact by construction: no tolerance.
TEST_CASE("toy star: eigenfunctions are 1 at the surface, even or odd") {
    for (const double gamma : {1.0001, 1.4, 2.0, 100.0}) {
        for (const int mode : {1, 2, 3, 10, 1000}) {
            CAPTURE(gamma, mode);
            const double sign = mode % 2 == 0 ? -1 : 1;
            CHECK(toy_star_velocity(gamma, mode, 1) == 1);
            CHECK(toy_star_velocity(gamma, mode, -1) == sign);
            CHECK(toy_star_velocity(gamma, mode, -0.37) == sign * toy_star_velocity(gamma, mode, 0.37));
            if (mode % 2 == 0) CHECK(toy_star_velocity(gamma, mode, 0) == 0);
        }
    }
}

// dP/dx = -rho Omega^2 x. Measured: 6.7e-12, rounding in the difference. Broken by a wrong factor of H, or
// the exponent (gamma-1).
TEST_CASE("toy star: at rest, pressure holds the force") {
    double worst = 0;
    for (const double gamma : {1.2, 1.4, 2.0, 3.0, 10.0}) {
        for (const double x : {0.1, 0.5, -0.7}) {
            CAPTURE(gamma, x);
            const double K = 0.3, Omega = 1.7;
            const auto pressure = [&](double s) {
                return K * std::pow(toy_star_density(gamma, K, Omega, x + s), gamma);
            };
            const double force = -toy_star_density(gamma, K, Omega, x) * Omega * Omega * x;
            worst =
                std::max(worst, std::fabs(finite_difference::derivatives(0.01, pressure).first / force - 1));
        }
    }
    CHECK(worst < 1e-10);
    CHECK(toy_star_density(2, 0.25, 1, 0) == 1);
    CHECK(toy_star_density(2, 0.25, 1, 1) == 0);
    CHECK(toy_star_density(2, 0.25, 1, -1.5) == 0);
}

// Fails for every check that is left out, and for a comparison that lets NaN pass.
TEST_CASE("toy star: a mode outside the range is named") {
    const double nan = std::nan("");
    CHECK_THAT(message_of([] { toy_star_frequency(1, 1); }), Catch::Contains("gamma = 1 "));
    CHECK_THAT(message_of([] { toy_star_frequency(100.5, 1); }), Catch::Contains("gamma = 100.5"));
    CHECK_THAT(message_of([] { toy_star_frequency(2, 0); }), Catch::Contains("mode = 0"));
    CHECK_THAT(message_of([] { toy_star_frequency(2, 1001); }), Catch::Contains("mode = 1001"));
    CHECK_THAT(message_of([&] { toy_star_velocity(nan, 1, 0); }), Catch::Contains("gamma"));
    CHECK_THAT(message_of([] { toy_star_velocity(2, -1, 0); }), Catch::Contains("mode = -1"));
    CHECK_THAT(message_of([] { toy_star_velocity(2, 1, 1.5); }), Catch::Contains("x = 1.5"));
    CHECK_THAT(message_of([&] { toy_star_velocity(2, 1, nan); }), Catch::Contains("x ="));
    CHECK_THAT(message_of([] { toy_star_density(0.5, 1, 1, 0); }), Catch::Contains("gamma = 0.5"));
    CHECK_THAT(message_of([] { toy_star_density(2, 0, 1, 0); }), Catch::Contains("K = 0"));
    CHECK_THAT(message_of([] { toy_star_density(2, 1, -1, 0); }), Catch::Contains("Omega = -1"));
    CHECK_THAT(message_of([&] { toy_star_density(2, 1, 1, nan); }), Catch::Contains("x ="));
    CHECK(message_of([] { toy_star_velocity(100, 1000, -1); }).empty());
}
