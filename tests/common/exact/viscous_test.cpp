// Two flows that viscosity alone slows down: TaylorGreen and ShearWave.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "common/exact/shear_wave.hpp"
#include "common/exact/taylor_green.hpp"
#include "tests/common/exact/derivatives.hpp"

using exact::ShearWave;
using exact::TaylorGreen;
using finite_difference::derivatives;
using std::numbers::pi;

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

// v_t + (v grad) v + grad p/rho - nu laplace v = 0 and div v = 0, over V^2/L and V/L, measured: 2.3e-10, of
// the differences. Fails for a wrong sign of the pressure, kx for 2kx, nu k^2 for 2 nu k^2, a lost density.
TEST_CASE("TaylorGreen: the Navier-Stokes equations") {
    const double nu = 0.03, V = 1.7, L = 2.5, rho = 1.3;
    const TaylorGreen flow{nu, V, L, rho};
    using State = TaylorGreen::State;
    double worst = 0, size = 0;
    for (const double x : {0.13, 0.8, -1.9}) {
        for (const double y : {0.37, 1.1, 2.2}) {
            const double t = 0.4, h = 0.01 * L;
            const auto in_x = [&](auto member) {
                return derivatives(h, [&](double s) { return flow.at(x + s, y, t).*member; });
            };
            const auto in_y = [&](auto member) {
                return derivatives(h, [&](double s) { return flow.at(x, y + s, t).*member; });
            };
            const auto in_t = [&](auto member) {
                return derivatives(0.02, [&](double s) { return flow.at(x, y, t + s).*member; }).first;
            };
            const State here = flow.at(x, y, t);
            const auto momentum = [&](auto member, double pressure_slope) {
                const auto a = in_x(member), b = in_y(member);
                size = std::max(size, std::fabs(here.v_x * a.first + here.v_y * b.first) * L / (V * V));
                return in_t(member) + here.v_x * a.first + here.v_y * b.first + pressure_slope / rho -
                       nu * (a.second + b.second);
            };
            const double divergence = in_x(&State::v_x).first + in_y(&State::v_y).first;
            worst = std::max({worst, std::fabs(momentum(&State::v_x, in_x(&State::p).first)) * L / (V * V),
                              std::fabs(momentum(&State::v_y, in_y(&State::p).first)) * L / (V * V),
                              std::fabs(divergence) * L / V});
        }
    }
    CHECK(worst < 1e-8);
    CHECK(size > 1);  // the terms are there
}

// Over a grid, of which the mean is exact. Measured: 2e-16. Fails for V^2/2 or b in place of 2b.
TEST_CASE("TaylorGreen: energy, mean pressure, decay") {
    const double nu = 0.03, V = 1.7, L = 2.5;
    const TaylorGreen flow{nu, V, L, 1.3};
    const double b = 2 * nu * std::pow(2 * pi / L, 2);
    CHECK(flow.decay_rate() == Approx(b).epsilon(1e-15));
    CHECK(flow.kinetic_energy(0) == Approx(V * V / 4).epsilon(1e-15));
    for (const double t : {0.0, 0.4, 5.0}) {
        constexpr int n = 8;
        double energy = 0, pressure = 0, fastest = 0;
        for (int k = 0; k < n * n; ++k) {
            const int row = k / n, column = k % n;
            const auto [v_x, v_y, p] = flow.at(L * column / n, L * row / n, t);
            energy += (v_x * v_x + v_y * v_y) / (2 * n * n);
            pressure += p / (n * n);
            fastest = std::max(fastest, std::hypot(v_x, v_y));
        }
        CHECK(energy == Approx(flow.kinetic_energy(t)).epsilon(1e-14));
        CHECK(flow.kinetic_energy(t) == Approx(V * V / 4 * std::exp(-2 * b * t)).epsilon(1e-14));
        CHECK(std::fabs(pressure) < 1e-14);
        CHECK(fastest == Approx(V * std::exp(-b * t)).epsilon(1e-14));
    }
    CHECK(TaylorGreen{0, 1, 1, 1}.at(0.25, 0, 1e50).v_y == 1);
    CHECK(flow.at(0.25, 0, 1e50).v_y == 0);
}

// v_x < 0 where y is small and positive: the direction of rotation. Fails for exchanged signs or coordinates,
// and for an argument that is not reduced.
TEST_CASE("TaylorGreen: directions and periods") {
    const TaylorGreen flow{0.01, 1, 2, 1};
    CHECK(flow.at(0, 0.5, 0).v_x == Approx(-1).epsilon(1e-15));
    CHECK(flow.at(0.5, 0, 0).v_y == Approx(1).epsilon(1e-15));
    CHECK(flow.at(0, 0, 0).p == Approx(-0.5).epsilon(1e-15));
    CHECK(flow.at(0.5, 0.5, 0).p == Approx(0.5).epsilon(1e-15));
    for (const double periods : {-3.0, 1.0, 1e6}) {
        const auto here = flow.at(0.25, 0.375, 1),
                   there = flow.at(0.25 + 2 * periods, 0.375 - 2 * periods, 1);
        CHECK((here.v_x == there.v_x && here.v_y == there.v_y && here.p == there.p));
    }
}

// v_t = nu v_xx. Measured: 2.3e-13 of nu k^2 V. Fails for k without 2 pi or n, and for 2 nu k^2.
TEST_CASE("ShearWave: the velocity diffuses") {
    double worst = 0;
    for (const int n : {1, 2, 7}) {
        const double nu = 0.03, V = 1.7, L = 2.5, t = 0.4;
        const ShearWave wave{nu, V, L, n};
        const double rate = nu * std::pow(2 * pi * n / L, 2);
        CHECK(wave.decay_rate() == Approx(rate).epsilon(1e-14));
        for (const double x : {0.13, 0.8, -1.9}) {
            const double change = derivatives(0.01, [&](double s) { return wave.velocity(x, t + s); }).first;
            const double curvature =
                derivatives(0.01 * L / n, [&](double s) { return wave.velocity(x + s, t); }).second;
            worst = std::max(worst, std::fabs(change - nu * curvature) / (rate * V));
        }
    }
    CHECK(worst < 1e-11);
}

// Fails for a cosine, a wrong number of waves, and for an argument that is not reduced.
TEST_CASE("ShearWave: values and periods") {
    const ShearWave wave{0.5, 3, 2, 2};
    CHECK(wave.velocity(0.25, 0) == Approx(3).epsilon(1e-15));
    CHECK(wave.velocity(0.75, 0) == Approx(-3).epsilon(1e-15));
    CHECK(wave.velocity(0, 0) == 0);
    CHECK(wave.velocity(0.25, 0.1) == Approx(3 * std::exp(-0.05 * 4 * pi * pi)).epsilon(1e-14));
    CHECK(wave.velocity(0.125 + 2e6, 0.1) == wave.velocity(0.125, 0.1));
    CHECK(wave.velocity(0.25, 1e50) == 0);
    CHECK(ShearWave{0, 3, 2, 2}.velocity(0.25, 1e50) == Approx(3).epsilon(1e-15));
}

// Fails for every check that is left out, and for a comparison that lets NaN pass.
TEST_CASE("TaylorGreen, ShearWave: what lies outside the range is named") {
    const double nan = std::nan("");
    const TaylorGreen flow{0.1, 1, 1, 1};
    const ShearWave wave{0.1, 1, 1, 1};
    CHECK_THAT(message_of([] { TaylorGreen(-1, 1, 1, 1); }), Catch::Contains("viscosity = -1"));
    CHECK_THAT(message_of([&] { TaylorGreen(nan, 1, 1, 1); }), Catch::Contains("viscosity"));
    CHECK_THAT(message_of([] { TaylorGreen(0, 0, 1, 1); }), Catch::Contains("speed = 0"));
    CHECK_THAT(message_of([] { TaylorGreen(0, 1, -2, 1); }), Catch::Contains("side = -2"));
    CHECK_THAT(message_of([] { TaylorGreen(0, 1, 1, 0); }), Catch::Contains("density = 0"));
    CHECK_THAT(message_of([&] { flow.at(nan, 0, 0); }), Catch::Contains("x ="));
    CHECK_THAT(message_of([&] { flow.at(0, nan, 0); }), Catch::Contains("y ="));
    CHECK_THAT(message_of([&] { flow.at(0, 0, -1); }), Catch::Contains("time = -1"));
    CHECK_THAT(message_of([&] { flow.kinetic_energy(nan); }), Catch::Contains("time"));
    CHECK_THAT(message_of([] { ShearWave(-1, 1, 1, 1); }), Catch::Contains("viscosity = -1"));
    CHECK_THAT(message_of([] { ShearWave(0, 1e51, 1, 1); }), Catch::Contains("speed = 1e+51 "));
    CHECK_THAT(message_of([] { ShearWave(0, 1, 0, 1); }), Catch::Contains("side = 0"));
    CHECK_THAT(message_of([] { ShearWave(0, 1, 1, 0); }), Catch::Contains("mode = 0"));
    CHECK_THAT(message_of([] { ShearWave(0, 1, 1, 1001); }), Catch::Contains("mode = 1001"));
    CHECK_THAT(message_of([&] { wave.velocity(nan, 0); }), Catch::Contains("x ="));
    CHECK_THAT(message_of([&] { wave.velocity(0, -1); }), Catch::Contains("time = -1"));
}
