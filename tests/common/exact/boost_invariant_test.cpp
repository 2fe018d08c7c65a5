// Bjorken's and Gubser's flow, what the slab is said to become, and their commands.
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/exact/bjorken.hpp"
#include "common/exact/gubser.hpp"
#include "common/exact/landau.hpp"
#include "common/exact/landau_asymptotic.hpp"
#include "common/exact/transverse_finite_volume.hpp"
#include "tests/common/exact/derivatives.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact::GubserFlow;
using exact::LandauAsymptotics;
using exact_program::check_refused;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;
using finite_difference::derivatives;

namespace {

struct GubserRow {
    double tau, r, eps, u_r;
};

}  // namespace

// To the 14 digits of another program's values, and with lengths in other units. Measured: 1.1e-15.
TEST_CASE("Gubser flow: the values of a table") {
    constexpr GubserRow rows[] = {{1, 0, 1, 0},
                                  {1, 0.5, 0.979539957443806, 0.496138938356834},
                                  {1, 3, 0.0169897929974411, 0.650791373455968},
                                  {2, 1, 0.0464158883361278, 0.894427190999916},
                                  {2, 6, 0.000220575339759337, 0.721988205115424},
                                  {4, 2.5, 0.00136827703001956, 1.68692299886234}};
    for (const double q : {1.0, 0.25, 3.0}) {
        for (const auto& row : rows) {
            const auto state = GubserFlow{q}.at(row.tau / q, row.r / q);
            CHECK(state.eps == Approx(row.eps * std::pow(q, 4)).epsilon(1e-13));
            CHECK(state.u_r == Approx(row.u_r).epsilon(1e-13));
        }
    }
}

// Measured: 1e-12, of the differences. Fails for another exponent or factor in eps, B or u^r.
TEST_CASE("Gubser flow: conserves entropy and energy") {
    const GubserFlow flow{0.7};
    for (const double tau : {0.5, 1.0, 3.0}) {
        for (const double r : {0.3, 1.0, 4.0}) {
            const auto u_tau = [&](double t, double s) { return std::hypot(1, flow.at(t, s).u_r); };
            const auto s_flux = [&](double t, double s) {
                const auto state = flow.at(t, s);
                return s * state.s_star * state.u_r / u_tau(t, s);
            };
            const double ds =
                derivatives(0.01, [&](double d) { return r * flow.at(tau + d, r).s_star; }).first;
            const double flux = derivatives(0.01, [&](double d) { return s_flux(tau, r + d); }).first;
            const auto e = [&](double t) {
                return t * r * flow.at(t, r).eps * (4 * std::pow(u_tau(t, r), 2) - 1) / 3;
            };
            const auto e_flux = [&](double s) {
                const auto state = flow.at(tau, s);
                return tau * s * state.eps * 4 * u_tau(tau, s) * state.u_r / 3;
            };
            const double de = derivatives(0.01, [&](double d) { return e(tau + d); }).first;
            const double df = derivatives(0.01, [&](double d) { return e_flux(r + d); }).first;
            CAPTURE(tau, r);
            CHECK(std::fabs(ds + flux) < 1e-8 * std::fabs(ds));
            CHECK(std::fabs(de + df + r * flow.at(tau, r).eps / 3) < 1e-8 * std::fabs(de));
        }
    }
    CHECK_THROWS_AS(GubserFlow{0}.at(1, 0), std::domain_error);
    CHECK_THROWS_AS(GubserFlow{}.at(0, 0), std::domain_error);
    CHECK_THROWS_AS(GubserFlow{}.at(1, -1), std::domain_error);
}

// Second order in smooth flow. Measured, L1 of eps in r < 2.5: 9.0e-4, 2.32e-4, order 1.96. Fails without v/r
// or 1/tau in the half step, and for sources that are not of the middle of the step.
TEST_CASE("rings follow Gubser's flow with second order") {
    const GubserFlow flow;
    const auto error = [&](std::size_t n) {
        exact::FluidCells cells{{0}, {}};
        for (std::size_t i = 0; i < n; ++i) {
            cells.faces.push_back(8 * static_cast<double>(i + 1) / static_cast<double>(n));
            const auto [eps, u, temperature, s] = flow.at(1, cells.centre(i));
            cells.states.push_back({eps, u / std::hypot(1, u)});
        }
        exact::TransverseFiniteVolume rings{cells, {}, {1, 0.5, 0}};
        rings.advance_to(1.5);
        cells = rings.cells();
        double off = 0, all = 0;
        for (std::size_t i = 0; i < n && cells.centre(i) < 2.5; ++i) {
            const double eps = flow.at(1.5, cells.centre(i)).eps;
            off += cells.centre(i) * std::fabs(cells.states[i].eps - eps);
            all += cells.centre(i) * eps;
        }
        return off / all;
    };
    const double coarse = error(100), fine = error(200);
    CAPTURE(coarse, fine);
    CHECK(fine < 2.6e-4);
    CHECK(std::log2(coarse / fine) > 1.8);
}

TEST_CASE("Bjorken flow: s, T and eps") {
    const auto state = exact::BjorkenFlow{2, 0.25}.at(32);
    CHECK(state.entropy == 1.0 / 16);
    CHECK(state.temperature == 0.5);
    CHECK(state.eps == 1.0 / 32);
    CHECK_THROWS_AS((exact::BjorkenFlow{1, 2}.at(1)), std::domain_error);
    CHECK_THROWS_AS((exact::BjorkenFlow{}.at(0)), std::domain_error);
}

// ln T at x = 0, of eq. 248 and of the slab. The two cross near t = 13 and drift apart.
TEST_CASE("Landau slab: equations 247-250 are no limit of it") {
    const auto asymptotic = [](double t) { return LandauAsymptotics{t}.at(0).log_temperature; };
    const auto slab = [](double t) { return std::log(exact::LandauSlab{t}.at(0).temperature); };
    CHECK(asymptotic(10) == Approx(-1.026).margin(1e-3));
    CHECK(slab(10) == Approx(-1.002).margin(1e-3));
    CHECK(asymptotic(100) == Approx(-1.793).margin(1e-3));
    CHECK(slab(100) == Approx(-1.894).margin(1e-3));
    CHECK(asymptotic(1e5) == Approx(-4.096).margin(1e-3));
    CHECK(slab(1e5) == Approx(-4.338).margin(1e-3));
    CHECK(asymptotic(12.9) < slab(12.9));
    CHECK(asymptotic(13.5) > slab(13.5));
    for (const double t : {100.0, 1e3, 1e4, 1e5})  // as (1/6) ln|ln T|, which is 0.011 to 0.021 below here
        CHECK(asymptotic(t) - slab(t) == Approx(std::log(-slab(t)) / 6).margin(0.025));
    const auto state = LandauAsymptotics{5}.at(3);
    CHECK(state.rapidity == Approx(std::atanh(0.6)));
    CHECK(state.log_bjorken == Approx(-std::log(4 / LandauAsymptotics::delta()) / 3));  // eq. 250
    CHECK_FALSE(LandauAsymptotics{5}.holds(4.6));
    CHECK_THROWS_AS(LandauAsymptotics{5}.at(4.6), std::domain_error);
}

// Fails if an option does not reach the solution, and for exchanged columns.
TEST_CASE("exact transverse, gubser, bjorken, landau --asymptotic: rows") {
    const auto gubser = GubserFlow{2}.at(1.5, 0.25);
    CHECK(numbers(lines(run("gubser --q 2 --tau 1.5 --r 0.25").text).back()) ==
          std::vector<double>{0.25, gubser.eps, gubser.u_r});
    CHECK(numbers(lines(run("bjorken --tau0 2 --sound-speed-squared 0.25 --tau 32").text).back()) ==
          std::vector<double>{32, 0.5, 1.0 / 32, 1.0 / 16});
    const auto rows =
        lines(run("transverse --radius 5 --tau0 0.5 --sound-speed-squared 0.2 --tau 4 --r 0,5,99").text);
    CHECK(rows[rows.size() - 4] == "r,temperature,rapidity");
    CHECK(numbers(rows[rows.size() - 3])[1] == Approx(std::pow(0.125, 0.2)).epsilon(1e-14));
    CHECK(numbers(rows[rows.size() - 2])[2] > 0.5);
    CHECK(rows.back() == "99,0,0");
    CHECK(numbers(lines(run("transverse --surface 0.5").text).back())[0] == Approx(8).epsilon(1e-14));
    const auto slab = lines(run("landau --asymptotic --time 100 --x 0,99.9").text);
    CHECK(std::log(numbers(slab[slab.size() - 2])[4]) == Approx(-1.793).margin(1e-3));
    CHECK(slab.back() == "99.900000000000006,0,0,0,0");
}

TEST_CASE("exact transverse, gubser, bjorken: bad usage is one line, status 2") {
    check_refused({
        {"transverse", "--r", "--points"},
        {"transverse --r 0 --tau 0.5", "--tau: 0.5", "1..70.28"},
        {"transverse --r 0 --tau 99", "--tau: 99", "1..70.28"},
        {"transverse --r 0 --radius 0", "--radius: 0", "1e-6..1e6"},
        {"transverse --r 0 --sound-speed-squared 1", "--sound-speed-squared: 1", "0.01..0.5"},
        {"transverse --r 0 --tau0 1e6 --tau 1e6", "--tau0: 1000000", "0.001..100000"},
        {"transverse --r -1", "--r: -1", ">= 0"},
        {"transverse --surface 0.01", "--surface: 0.01", "0.05"},
        {"transverse --surface 0.5 --r 1", "--surface", "--r"},
        {"gubser --r 1 --q 0", "--q: 0", "1e-6..1e6"},
        {"gubser --r -1", "--r: -1", "0..1e6"},
        {"bjorken --tau 0", "--tau: 0", "> 0"},
        {"landau --asymptotic --time 0.5 --x 0", "--time: 0.5", "1..1e6"},
    });
}
