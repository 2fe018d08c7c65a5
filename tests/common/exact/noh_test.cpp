#include "common/exact/noh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/common/exact/gas_equations.hpp"

using exact::Noh;

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

// The case of Noh (1987), gamma = 5/3: the densities 4^d, and R = 0.2 at t = 0.6. Fails for a wrong exponent
// or an exchanged factor.
TEST_CASE("Noh: the values of the paper") {
    for (const int d : {1, 2, 3}) {
        CAPTURE(d);
        const Noh noh{d, 5.0 / 3, 1, 1};
        CHECK(noh.shock_speed() == Approx(1.0 / 3).epsilon(1e-15));
        CHECK(noh.shock_position(0.6) == Approx(0.2).epsilon(1e-15));
        const auto behind = noh.at(0.19, 0.6);
        CHECK(behind.rho == Approx(std::pow(4, d)).epsilon(1e-14));  // measured 4e-16
        CHECK(behind.v == 0);
        CHECK(behind.u == 0.5);
        CHECK(behind.p == Approx(std::pow(4, d) / 3).epsilon(1e-14));
        const auto ahead = noh.at(0.3, 0.6);
        CHECK(ahead.rho == Approx(std::pow(3, d - 1)).epsilon(1e-14));
        CHECK((ahead.v == -1 && ahead.p == 0 && ahead.u == 0));
    }
}

// Measured: 2.7e-14, from the differences. Fails for the exponent d in place of d - 1, and for 1 - v0 t/r.
TEST_CASE("Noh: the gas ahead of the shock obeys the equations of gas motion") {
    double worst = 0;
    for (const int d : {1, 2, 3}) {
        for (const double gamma : {1.1, 1.4, 5.0 / 3, 3.0}) {
            const Noh noh{d, gamma, 1.3, 0.7};
            for (const double t : {0.1, 2.0}) {
                const double r = 1.5 * noh.shock_position(t) + 0.1;
                worst = std::max(worst, gas_equations::residual(noh, d, r, t, 0.005 * r, 0.005 * t));
            }
        }
    }
    CHECK(worst < 1e-12);
}

// Measured: 4.4e-16. Fails for any error in a state behind the shock or in its speed, and for another
// convergence of the flow ahead.
TEST_CASE("Noh: mass, momentum and energy are conserved across the shock") {
    double worst = 0;
    for (const int d : {1, 2, 3}) {
        for (const double gamma : {1.05, 1.4, 5.0 / 3, 3.0, 100.0}) {
            const Noh noh{d, gamma, 1.3, 0.7};
            const double R = noh.shock_position(2);
            worst = std::max(worst, gas_equations::jump_error(noh.at(std::nextafter(R, 1e9), 2), noh.at(R, 2),
                                                              noh.shock_speed()));
        }
    }
    CHECK(worst < 1e-14);
}

// What is in r < X was in r < X + v0 t. Measured: 1.3e-10, of the 20000 cells. Fails for any wrong density.
TEST_CASE("Noh: mass and energy stay what they were") {
    for (const int d : {1, 2, 3}) {
        const double gamma = 1.4, rho0 = 1.3, v0 = 0.7, t = 1.5, X = 2;
        const Noh noh{d, gamma, rho0, v0};
        const double R = noh.shock_position(t), surface = d == 1 ? 2 : 2 * (d - 1) * std::numbers::pi;
        double mass = noh.post_shock().rho * surface * std::pow(R, d) / d, energy = mass * noh.post_shock().u;
        constexpr int cells = 20000;
        for (int k = 0; k < cells; ++k) {
            const double dr = (X - R) / cells, r = R + (k + 0.5) * dr;
            const auto [rho, v, p, u] = noh.at(r, t);
            const double part = rho * surface * std::pow(r, d - 1) * dr;
            mass += part;
            energy += part * (v * v / 2 + u);
        }
        const double was = rho0 * surface * std::pow(X + v0 * t, d) / d;
        CHECK(mass == Approx(was).epsilon(1e-9));
        CHECK(energy == Approx(was * v0 * v0 / 2).epsilon(1e-9));
    }
}

// Fails for a lost sign, for < in place of <=, and for a division 0/0.
TEST_CASE("Noh: both sides of a plane, the shock itself, the start") {
    const Noh plane{1, 1.4, 2, 3};
    for (const double x : {0.1, 0.7, 5.0}) {
        CHECK(plane.at(-x, 1).rho == plane.at(x, 1).rho);
        CHECK(plane.at(-x, 1).v == -plane.at(x, 1).v);
        CHECK(plane.at(-x, 1).u == plane.at(x, 1).u);
    }
    CHECK(plane.at(-5, 1).v == 3);
    for (const int d : {1, 2, 3}) {
        const Noh noh{d, 1.4, 2, 3};
        CHECK(noh.at(noh.shock_position(1), 1).v == 0);
        CHECK(noh.at(std::nextafter(noh.shock_position(1), 9), 1).v == -3);
        CHECK(noh.at(1e-300, 0).rho == 2);
        CHECK(noh.at(1e-300, 0).v == -3);
        CHECK(noh.at(0, 0).v == 0);
        CHECK(noh.at(1e300, 1).rho == 2);
        const Noh extreme{d, 1 + 1e-15, 1e50, 1e50};
        CHECK(std::isfinite(extreme.at(0, 1e50).p));
        CHECK(std::isfinite(extreme.at(1e101, 1e50).rho));
    }
}

// Fails for every check that is left out, and for a comparison that lets NaN pass.
TEST_CASE("Noh: what lies outside the range is named") {
    const double nan = std::nan("");
    const Noh noh{2, 1.4, 1, 1};
    CHECK_THAT(message_of([] { Noh(0, 1.4, 1, 1); }), Catch::Contains("dimension = 0"));
    CHECK_THAT(message_of([] { Noh(4, 1.4, 1, 1); }), Catch::Contains("dimension = 4"));
    CHECK_THAT(message_of([] { Noh(1, 1, 1, 1); }), Catch::Contains("gamma = 1 "));
    CHECK_THAT(message_of([] { Noh(1, 101, 1, 1); }), Catch::Contains("gamma = 101"));
    CHECK_THAT(message_of([&] { Noh(1, nan, 1, 1); }), Catch::Contains("gamma"));
    CHECK_THAT(message_of([] { Noh(1, 1.4, 0, 1); }), Catch::Contains("density = 0"));
    CHECK_THAT(message_of([] { Noh(1, 1.4, 1, -1); }), Catch::Contains("speed = -1"));
    CHECK_THAT(message_of([] { Noh(1, 1.4, 1, 1e51); }), Catch::Contains("speed = 1e+51 "));
    CHECK_THAT(message_of([&] { noh.at(-0.5, 1); }), Catch::Contains("x = -0.5"));
    CHECK_THAT(message_of([&] { Noh(1, 1.4, 1, 1).at(nan, 1); }), Catch::Contains("x ="));
    CHECK_THAT(message_of([&] { noh.at(HUGE_VAL, 1); }), Catch::Contains("x = inf"));
    CHECK_THAT(message_of([&] { noh.at(1, -1); }), Catch::Contains("time = -1"));
    CHECK_THAT(message_of([&] { noh.at(1, nan); }), Catch::Contains("time"));
    CHECK_THAT(message_of([&] { noh.shock_position(1e51); }), Catch::Contains("time"));
    CHECK(message_of([] { Noh(1, 1.4, 1, 1).at(-0.5, 1); }).empty());
}
