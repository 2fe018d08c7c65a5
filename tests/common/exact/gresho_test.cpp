// Gresho's vortex, the command `exact gresho`, and the instability of sliding streams.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "common/exact/gresho.hpp"
#include "common/exact/shear_instability.hpp"
#include "tests/common/exact/derivatives.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact::Gresho;
using exact::ShearInstability;
using finite_difference::derivatives;

// Measured: 2e-10. Fails for a pressure without its logarithm, a lost density, s for s^2.
TEST_CASE("Gresho: the pressure holds the vortex, and has no jumps") {
    const Gresho vortex{1.7, 0.3, 1.3, 4};
    for (const double r : {0.05, 0.2, 0.35, 0.5, 0.7}) {
        const double slope = derivatives(0.001, [&](double s) { return vortex.at(r + s).p; }).first;
        const double v = vortex.at(r).v;
        CHECK(slope == Approx(1.3 * v * v / r).margin(1e-8));
    }
    for (const double edge : {0.3, 0.6}) {
        CHECK(vortex.at(edge - 1e-12).p == Approx(vortex.at(edge + 1e-12).p).epsilon(1e-10));
        CHECK(vortex.at(edge - 1e-12).v == Approx(vortex.at(edge + 1e-12).v).margin(1e-10));
    }
    CHECK(vortex.at(0.3).v == 1.7);
    CHECK(vortex.at(0).p == 4);
}

// Liska & Wendroff's numbers for V = 1, R = 0.2, p_0 = 5. Fails for exchanged columns and other defaults.
TEST_CASE("exact gresho: header and values") {
    const auto all = exact_program::lines(exact_program::run("gresho --r 0.1,0.3,0.45").text);
    REQUIRE(all.size() == 5 + 3);
    CHECK(exact_program::constant(all[1], "radius") == 0.2);
    const std::string header[] = {"# speed=1", all[1], "# density=1", "# pressure=5", "r,v,p"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    const double r[] = {0.1, 0.3, 0.45}, v[] = {0.5, 0.5, 0};
    const double p[] = {5.125, 9 + 12.5 * 0.09 - 20 * 0.3 + 4 * std::log(1.5), 3 + 4 * std::log(2.0)};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<double> row = exact_program::numbers(all[k + 5]);
        REQUIRE(row.size() == 3);
        CHECK(row[0] == r[k]);
        CHECK(row[1] == Approx(v[k]).margin(1e-15));
        CHECK(row[2] == Approx(p[k]).epsilon(1e-14));
    }
}

// Fails for every check that is left out.
TEST_CASE("exact gresho: bad usage is one line that names the mistake, status 2") {
    exact_program::check_refused({
        {"gresho", "--r", "--points"},
        {"gresho --r -1", "--r", "-1"},
        {"gresho --r 0.1 --speed 0", "--speed", "0"},
        {"gresho --r 0.1 --radius inf", "--radius", "inf"},
        {"gresho --r 0.1 --density -1", "--density", "-1"},
        {"gresho --r 0.1 --pressure -1", "--pressure", "-1"},
    });
}

// The linear Euler equations of x-momentum, y-momentum and energy, and of mass, over the largest term,
// measured: 2e-4, of 64 points. Fails for any wrong sign, a lost 1/rho, and a mode of another matrix.
TEST_CASE("ShearInstability: its mode solves the linear equations and grows") {
    const ShearInstability::Flow flow{};
    const ShearInstability streams{flow};
    constexpr double k = 6.283185307179586, step = 1e-4;
    double worst = 0, largest = 0;
    for (const double y : {0.02, 0.1, 0.27, 0.49, 0.55, 0.97}) {
        using State = ShearInstability::State;
        const auto complex = [&](double State::*of, double at) {  // f exp(i k x) at x = 0
            return std::complex<double>{(streams.disturbance(0, at).*of),
                                        -(streams.disturbance(0.25, at).*of)};
        };
        const auto slope = [&](double State::*of) {
            return (complex(of, y + step) - complex(of, y - step)) / (2 * step);
        };
        const State base = streams.base(y);
        const double U_y = (streams.base(y + step).v_x - streams.base(y - step).v_x) / (2 * step);
        const double rho_y = (streams.base(y + step).rho - streams.base(y - step).rho) / (2 * step);
        const std::complex<double> i{0, 1}, u = complex(&State::v_x, y), v = complex(&State::v_y, y),
                                            p = complex(&State::p, y), rho = complex(&State::rho, y);
        const auto rate = i * (k * base.v_x - streams.omega());  // d/dt + U d/dx
        const auto divergence = i * k * u + slope(&State::v_y);
        for (const auto& left :
             {rate * u + U_y * v + i * k * p / base.rho, rate * v + slope(&State::p) / base.rho,
              (rate * p + flow.gamma * flow.pressure * divergence) / flow.pressure,
              rate * rho + rho_y * v + base.rho * divergence})
            worst = std::max(worst, std::abs(left));
        largest = std::max(largest, std::abs(rate * v));
    }
    CHECK(worst < 2e-3 * largest);
    CHECK(streams.growth() == Approx(1.7055).epsilon(1e-3));
}

// Michalke 1964, table 1: c_i = 0.837 at alpha = 0.1 and 0.698 at 0.2 of one layer. Two layers, half a period
// apart, see each other by exp(-pi) = 4 %. Measured: 0.1013 at alpha = 0.1257, between. Fails for U_y of half
// the width.
TEST_CASE("ShearInstability: the growth of a single layer") {
    const ShearInstability slow{{.speed = 0.05, .inner = 1, .outer = 1, .width = 0.02}, 192};
    const double alpha = 6.283185307179586 * 0.02, c_i = 0.837 + (0.698 - 0.837) * (alpha - 0.1) / 0.1;
    CHECK(slow.growth() * 0.02 / 0.05 == Approx(alpha * c_i).epsilon(0.05));
    CHECK(ShearInstability{{.speed = 0.05, .width = 0.2}, 32}.growth() < 0.05);
    CHECK_THROWS_AS((ShearInstability{{.width = 0.001}}), std::domain_error);
    CHECK_THROWS_AS((ShearInstability{{}, 15}), std::domain_error);
}
