#include "common/exact/rarefaction.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "tests/common/exact/derivatives.hpp"

using exact::Rarefaction;
using finite_difference::derivatives;

namespace {

Rarefaction figure_14(double gamma = 1.4) {
    return {1, 2, gamma, 0.5};
}

std::string message_of(const auto& call) {
    try {
        call();
    } catch (const std::domain_error& error) {
        return error.what();
    }
    return "";
}

double relative(double value, double expected) {
    return std::fabs(value / expected - 1);
}

}  // namespace

// Values of the formulae, with 80 digits (python-mpmath), for exactly the doubles here. Measured: 3.3e-14 at
// x = 1, where 0.05 of the fan's width is left to the front; 5.1e-15 elsewhere. Broken by gamma - 1 for
// gamma + 1, by the exponent 2 gamma/(gamma-1) of rho, by v = (x - head)/t without its factor.
TEST_CASE("Rarefaction: the values of a table") {
    struct Row {
        double t, x, rho, v, p, u;
    };
    const Row rows[] = {
        {0.1, 0.5, 0.401877572016460898, 0.88191710368819677, 0.223265317786922688, 1.38888888888888899},
        {0.1, 0.4, 0.954927941483366199, 0.0485837703548636374, 0.749978526103668987, 1.96344272044932345},
        {0.1, 0.75, 0.0164205950883386108, 2.96525043702153007, 0.00253883476073950138, 0.386532087765580186},
        {0.1, 1.0, 2.03897086347888933e-7, 5.04858377035486336, 3.43767974098609743e-10,
         0.00421496918195379907},
        {0.4, 0.25, 0.702302150142151437, 0.361083770354863447, 0.487779544992752164, 1.73635928956654157},
        {0.4, 2, 0.000843179483173914589, 4.00691710368819671, 0.000039753743352193592, 0.11786856815630669},
        {0.47, 0.01, 0.987661491111652196, 0.0131227774470619374, 0.786215056106927539, 1.99009241319617381},
    };
    double worst = 0, beside = 0;
    for (const auto& row : rows) {
        const auto [rho, v, p, u] = figure_14().at(row.x, row.t);
        const double error =
            std::max({relative(rho, row.rho), relative(v, row.v), relative(p, row.p), relative(u, row.u)});
        (row.x == 1 ? beside : worst) = std::max(row.x == 1 ? beside : worst, error);
    }
    CHECK(worst < 5e-14);
    CHECK(beside < 2e-13);
    CHECK(figure_14().sound_speed() == Approx(1.0583005244258360851).epsilon(1e-15).margin(0));
    CHECK(figure_14().meeting_time() == Approx(0.47245559126153410146).epsilon(1e-15).margin(0));
    CHECK(figure_14().head(0.1) == Approx(0.39416994755741639).epsilon(1e-15).margin(0));
    CHECK(figure_14().front(0.1) == Approx(1.0291502622129180).epsilon(1e-15).margin(0));
}

// Continuity, momentum, and u_t + v u_x + (p/rho) v_x = 0 in the fan. Residual over the terms' magnitudes,
// measured: 1.7e-12. Broken by any wrong factor or exponent, also of the places of head and front.
TEST_CASE("Rarefaction: the fan obeys the equations of gas motion") {
    double worst = 0;
    for (const double gamma : {1.05, 1.4, 5.0 / 3, 2.0, 3.0}) {
        const Rarefaction solution{1.3, 0.7, gamma, 0.8};
        for (const double part : {0.1, 0.4, 0.8}) {
            const double t = 0.6 * solution.meeting_time();
            const double x = std::lerp(solution.head(t), solution.front(t), part);
            CAPTURE(gamma, part);
            // fractions of the lengths and times in which rho ~ (front - x)^(2/(gamma-1)) varies
            const double dx = 0.005 * std::min(gamma - 1, 1.0) * (solution.front(t) - x);
            const double dt = dx / (solution.at(x, t).v + solution.sound_speed());
            const auto in_x = [&](auto member) {
                return derivatives(dx, [&](double s) { return solution.at(x + s, t).*member; }).first;
            };
            const auto in_t = [&](auto member) {
                return derivatives(dt, [&](double s) { return solution.at(x, t + s).*member; }).first;
            };
            using State = Rarefaction::State;
            const auto [rho, v, p, u] = solution.at(x, t);
            const double v_x = in_x(&State::v);
            const double a = in_t(&State::rho), b = v * in_x(&State::rho) + rho * v_x;
            const double c = in_t(&State::v), d = v * v_x + in_x(&State::p) / rho;
            const double e = in_t(&State::u), f = v * in_x(&State::u) + p / rho * v_x;
            worst = std::max({worst, std::fabs(a + b) / (std::fabs(a) + rho * v_x),
                              std::fabs(c + d) / (std::fabs(c) + v * v_x),
                              std::fabs(e + f) / (std::fabs(e) + p / rho * v_x)});
        }
    }
    CHECK(worst < 3e-11);
}

// dx/dt = v and rho = rho0 / (dx/dx0), against differences. Measured: 1.0e-12. Broken by the exponent
// 2/(gamma+1) for (gamma-1)/(gamma+1) in the form that the header gives, and by a lost c0.
TEST_CASE("Rarefaction: the trajectories move with the gas and carry its mass") {
    double worst = 0;
    for (const double gamma : {1.05, 1.4, 5.0 / 3, 3.0}) {
        const Rarefaction solution{1.3, 0.7, gamma, 0.8};
        for (const double x0 : {0.3, 0.55, -0.6, 0.75}) {
            const double reached = (0.8 - std::fabs(x0)) / solution.sound_speed();
            for (const double part : {0.2, 0.9}) {
                const double t = std::lerp(reached, solution.meeting_time(), part);
                CAPTURE(gamma, x0, t);
                const double dt = 0.01 * std::min(t - reached, solution.meeting_time() - t);
                const double dx0 = 0.01 * std::min(0.8 - std::fabs(x0), std::fabs(x0));
                const auto speed = derivatives(dt, [&](double s) { return solution.trajectory(x0, t + s); });
                const auto stretch =
                    derivatives(dx0, [&](double s) { return solution.trajectory(x0 + s, t); });
                const auto state = solution.at(solution.trajectory(x0, t), t);
                worst = std::max(
                    {worst, relative(speed.first, state.v), relative(1.3 / stretch.first, state.rho)});
            }
        }
    }
    CHECK(worst < 3e-11);
}

// Solutions of dx/dt = v(x, t) with 25 digits (mpmath.odefun). Measured: 6.7e-16.
TEST_CASE("Rarefaction: the trajectories of a table") {
    CHECK(figure_14().trajectory(0.4, 0.3) == Approx(0.516148272365982247).epsilon(1e-14).margin(0));
    CHECK(figure_14().trajectory(0.25, 0.4) == Approx(0.290124098796117032).epsilon(1e-14).margin(0));
    CHECK(figure_14().trajectory(-0.45, 0.47) == Approx(-0.951986418077582326).epsilon(1e-14).margin(0));
    CHECK(figure_14().trajectory(0.1, 0.4) == Approx(0.100554039316818453).epsilon(1e-14).margin(0));
}

// No tolerance where the values are exact. Fails for < in place of <=, or a lost copysign.
TEST_CASE("Rarefaction: gas at rest, vacuum, edges, both sides") {
    for (const double gamma : {1 + 1e-9, 1.4, 3.0, 100.0}) {
        const auto solution = figure_14(gamma);
        for (const double t : {0.0, 0.3 * solution.meeting_time(), solution.meeting_time()}) {
            CAPTURE(gamma, t);
            const auto inside = solution.at(0.999 * solution.head(t), t);
            CHECK(inside.rho == 1);
            CHECK(inside.v == 0);
            CHECK(inside.p == (gamma - 1) * 2);
            CHECK(inside.u == 2);
            CHECK(solution.trajectory(0.999 * solution.head(t), t) == 0.999 * solution.head(t));
            for (const double x : {t == 0 ? 0.5000001 : solution.front(t), 1e300}) {
                for (const double side : {-1.0, 1.0}) {
                    const auto [rho, v, p, u] = solution.at(side * x, t);
                    CHECK((rho == 0 && v == 0 && p == 0 && u == 0));
                }
            }
            CHECK(solution.trajectory(0.5, t) == Approx(solution.front(t)).epsilon(1e-15).margin(0));
            const double x = std::lerp(solution.head(t), solution.front(t), 0.4);
            CHECK(solution.at(-x, t).rho == solution.at(x, t).rho);
            CHECK(solution.at(-x, t).v == -solution.at(x, t).v);
            CHECK(solution.trajectory(-0.3, t) == -solution.trajectory(0.3, t));
        }
        CHECK(solution.at(0.5, 0).rho == 1);
        CHECK(solution.at(-0.5, 0).u == 2);
    }
}

// gamma -> 1 is the isothermal fan, rho = rho0 exp(-v/c0). Measured: 2.0e-9 of rho and 5e-10 of v, which is
// the distance from the limit at gamma - 1 = 1e-9. Broken by ln of (front - x)/(front - head), which is
// rounded near 1: 2.3e-7.
TEST_CASE("Rarefaction: nearly isothermal gas") {
    const auto solution = figure_14(1 + 1e-9);
    const double c0 = solution.sound_speed(), t = 0.5 * solution.meeting_time();
    double worst = 0;
    for (int k = 1; k < 400; ++k) {
        const double over = k * 0.0101937;  // no multiple of the last place of 1 - c/c0
        const auto state = solution.at(solution.head(t) + over * c0 * t, t);
        worst = std::max({worst, relative(state.v, over * c0), relative(state.rho, std::exp(-over))});
    }
    CHECK(worst < 2e-8);
}

// Fails for every check that is left out, and for a comparison that lets NaN pass.
TEST_CASE("Rarefaction: what lies outside the range is named") {
    const double nan = std::nan(""), late = 1.001 * figure_14().meeting_time();
    CHECK_THAT(message_of([] { Rarefaction(0, 2, 1.4, 0.5); }), Catch::Contains("rho = 0"));
    CHECK_THAT(message_of([] { Rarefaction(1, -2, 1.4, 0.5); }), Catch::Contains("u = -2"));
    CHECK_THAT(message_of([] { Rarefaction(1, 2, 1, 0.5); }), Catch::Contains("gamma = 1 "));
    CHECK_THAT(message_of([] { Rarefaction(1, 2, 101, 0.5); }), Catch::Contains("gamma = 101"));
    CHECK_THAT(message_of([&] { Rarefaction(1, 2, nan, 0.5); }), Catch::Contains("gamma"));
    CHECK_THAT(message_of([] { Rarefaction(1, 2, 1.4, 1e101); }), Catch::Contains("half width = 1e+101 "));
    CHECK_THAT(message_of([] { figure_14().at(0, -1); }), Catch::Contains("time = -1"));
    CHECK_THAT(message_of([&] { figure_14().at(0, late); }), Catch::Contains("time = 0.47292"));
    CHECK_THAT(message_of([&] { figure_14().at(nan, 0.1); }), Catch::Contains("x ="));
    CHECK_THAT(message_of([&] { figure_14().at(0, nan); }), Catch::Contains("time"));
    CHECK_THAT(message_of([&] { figure_14().head(late); }), Catch::Contains("time"));
    CHECK_THAT(message_of([&] { figure_14().front(late); }), Catch::Contains("time"));
    CHECK_THAT(message_of([&] { figure_14().trajectory(0, late); }), Catch::Contains("time"));
    CHECK_THAT(message_of([] { figure_14().trajectory(0.6, 0.1); }), Catch::Contains("x0 = 0.6 "));
    CHECK(message_of([] { figure_14().at(0, figure_14().meeting_time()); }).empty());
}
