// The Riemann problem of an ideal gas: `exact riemann`.
#include "common/exact/riemann.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/common/exact/exact_program.hpp"

using exact::Riemann;

namespace {

struct Known {
    std::string name;
    double gamma;
    Riemann::State left, right;
    double p, v, rho_left, rho_right;
};
/// Toro's five tests, Sod's, and the two tubes of Inutsuka 2002, from an independent computation with 15
/// digits.
const std::vector<Known> table{
    {"toro1",
     1.4,
     {1, 0.75, 1},
     {0.125, 0, 0.1},
     0.466293566839856,
     1.36090551909256,
     0.579866687480324,
     0.339700234901907},
    {"toro2", 1.4, {1, -2, 0.4}, {1, 2, 0.4}, 0.00189387342005476, 0, 0.0218521182068128, 0.0218521182068128},
    {"toro3",
     1.4,
     {1, 0, 1000},
     {1, 0, 0.01},
     460.893787491384,
     19.5974513887231,
     0.575062298476555,
     5.99924070479623},
    {"toro4",
     1.4,
     {5.99924, 19.5975, 460.894},
     {5.99242, -6.19633, 46.095},
     1691.64695539913,
     8.68977441163238,
     14.2823499519784,
     31.0426016416199},
    {"toro5",
     1.4,
     {1, -19.59745, 1000},
     {1, -19.59745, 0.01},
     460.893787491384,
     1.38872305244123e-6,
     0.575062298476555,
     5.99924070479623},
    {"sod",
     1.4,
     {1, 0, 1},
     {0.125, 0, 0.1},
     0.303130178050647,
     0.92745262004895,
     0.426319428178495,
     0.265573711705307},
    {"mach",
     1.4,
     {1, 0, 1},
     {0.5, 0, 0.2},
     0.509864033213713,
     0.542771101035257,
     0.618071674403607,
     0.953053615952315},
    {"blast",
     5.0 / 3,
     {1, 0, 3000},
     {1, 0, 1e-7},
     1336.85705110458,
     31.6645351799089,
     0.615712867474828,
     3.99999999887797}};

/// How far the wave between `side` (seen as the left one) and the star state is from the jump conditions of a
/// shock, or from the invariants of a rarefaction: relative.
double wave_error(const Riemann::State& side, double p, double v, double rho, double gamma) {
    if (p > side.p) {
        // Mass flux through the shock in two ways, and the energy jump (Hugoniot).
        const double flux2 = (p - side.p) / (1 / side.rho - 1 / rho);
        const double momentum = std::abs((side.v - v) * std::sqrt(flux2) - (p - side.p)) / p;
        const double u = p / ((gamma - 1) * rho), u_side = side.p / ((gamma - 1) * side.rho);
        const double hugoniot = std::abs(u - u_side - (p + side.p) / 2 * (1 / side.rho - 1 / rho)) / u;
        return std::max(momentum, hugoniot);
    }
    const double entropy = std::abs(std::log(p / side.p) - gamma * std::log(rho / side.rho));
    const double c = std::sqrt(gamma * p / rho), c_side = std::sqrt(gamma * side.p / side.rho);
    const double invariant = std::abs(v + 2 * c / (gamma - 1) - side.v - 2 * c_side / (gamma - 1)) /
                             (2 * c_side / (gamma - 1) + std::abs(side.v));
    return std::max(entropy, invariant);
}

Riemann::State mirrored(const Riemann::State& state) {
    return {state.rho, -state.v, state.p};
}

}  // namespace

TEST_CASE("riemann: the digits of an independent computation") {
    for (const Known& known : table) {
        INFO(known.name);
        const Riemann::Star star = Riemann{known.left, known.right, known.gamma}.star();
        CHECK(star.p == Approx(known.p).epsilon(1e-13));  // measured 3e-15
        CHECK(star.rho_left == Approx(known.rho_left).epsilon(1e-13));
        CHECK(star.rho_right == Approx(known.rho_right).epsilon(1e-13));
        // toro5's is a difference of velocities of 20, which themselves are rounded.
        CHECK(star.v == Approx(known.v).epsilon(1e-13).margin(2e-14));
        CHECK(!star.vacuum);
    }
}

TEST_CASE("riemann: jump conditions and invariants hold for 20000 random problems") {
    std::mt19937_64 bits{1};
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    };
    double worst = 0;
    int shocks = 0, vacua = 0;
    for (int k = 0; k < 20000; ++k) {
        const double gamma = 1.01 + uniform(0, 1) * 1.99;
        const auto state = [&] {
            return Riemann::State{std::pow(10, uniform(-3, 3)), uniform(-3, 3), std::pow(10, uniform(-6, 6))};
        };
        const Riemann::State left = state(), right = state();
        const Riemann problem{left, right, gamma};
        const Riemann::Star star = problem.star();
        if (star.vacuum) {
            ++vacua;
            continue;
        }
        // Where the shock is weak its flux is a quotient of small differences, and where the gas has nearly
        // become a vacuum the invariants are: neither tests the solution there.
        const auto counts = [&](const Riemann::State& s) {
            return star.p > 1.1 * s.p || (star.p < s.p && star.p > 1e-6 * s.p);
        };
        if (counts(left)) worst = std::max(worst, wave_error(left, star.p, star.v, star.rho_left, gamma));
        if (counts(right))
            worst = std::max(worst, wave_error(mirrored(right), star.p, -star.v, star.rho_right, gamma));
        shocks += (star.p > left.p) + (star.p > right.p);
        const Riemann reflected{mirrored(right), mirrored(left), gamma};
        CHECK(reflected.star().p == star.p);
        CHECK(reflected.star().v == -star.v);
    }
    CHECK(worst < 1e-11);
    CHECK(shocks > 5000);
    CHECK(vacua > 100);
}

TEST_CASE("riemann: nothing happens between equal states, and extremes stay finite") {
    const Riemann same{{1, 2, 3}, {1, 2, 3}, 1.4};
    CHECK(same.star().p == 3);
    CHECK(same.star().v == 2);
    CHECK(same.star().rho_left == 1);
    for (const double xi : {-10.0, 0.0, 2.0, 10.0}) CHECK(same.at(xi).rho == 1);
    for (const double gamma : {1.01, 1.4, 3.0}) {
        for (const double ratio : {1e-12, 1e-6, 1e6, 1e12, 1e30}) {
            const Riemann::Star star = Riemann{{1, 0, ratio}, {1, 0, 1}, gamma}.star();
            CHECK(star.p > std::min(1.0, ratio));
            CHECK(star.p < std::max(1.0, ratio));
            CHECK(std::isfinite(star.v));
        }
    }
    // Cold gas: two strong shocks, p = (v/2)^2 (gamma+1)/2 rho for |v| of closing.
    const Riemann cold{{1, 1, 0}, {1, -1, 0}, 1.4};
    CHECK(cold.star().p == Approx(1.2).epsilon(1e-14));
    CHECK(cold.star().rho_left == Approx(6).epsilon(1e-14));
}

TEST_CASE("riemann: inside the waves and across them") {
    // Sod at x/t: rest, fan, star left, star right, rest. The fan ends at -0.0702728125611833.
    const Riemann sod{{1, 0, 1}, {0.125, 0, 0.1}, 1.4};
    const double c = std::sqrt(1.4);
    CHECK(sod.at(-1.2).rho == 1);
    const Riemann::Point fan = sod.at(-0.5);
    CHECK(fan.v == Approx(2 / 2.4 * (c - 0.5)).epsilon(1e-14));
    CHECK(fan.p / std::pow(fan.rho, 1.4) == Approx(1).epsilon(1e-14));
    CHECK(sod.at(-0.0702728).rho == Approx(sod.star().rho_left).epsilon(1e-6));
    CHECK(sod.at(0.9274).rho == sod.star().rho_left);
    CHECK(sod.at(0.9275).rho == sod.star().rho_right);
    CHECK(sod.at(1.7521557).rho == sod.star().rho_right);
    CHECK(sod.at(1.7521558).rho == 0.125);  // Sod's shock runs at 1.75215573203018
    CHECK(sod.at(0.5, 0.25).u == sod.at(2.0).u);
    CHECK(sod.at(-1e-9, 0).rho == 1);
    CHECK(sod.at(0, 0).rho == 0.125);
    const Riemann::Waves& waves = sod.waves();
    CHECK(waves.left.head == Approx(-c).epsilon(1e-14));
    CHECK(waves.left.tail == Approx(-0.0702728125611833).epsilon(1e-13));
    CHECK(!waves.left.shock);
    CHECK(waves.contact == sod.star().v);
    CHECK(waves.right.head == Approx(1.75215573203018).epsilon(1e-14));
    CHECK(waves.right.tail == waves.right.head);
    CHECK(waves.right.shock);
    const Riemann::Waves other = Riemann{{0.125, 0, 0.1}, {1, 0, 1}, 1.4}.waves();
    CHECK(other.left.head == -waves.right.head);
    CHECK(other.left.shock);
    CHECK(other.right.tail == -waves.left.tail);
}

TEST_CASE("riemann: vacuum between and beside") {
    const Riemann between{{1, -10, 1}, {1, 10, 1}, 1.4};
    CHECK(between.star().vacuum);
    CHECK(between.star().p == 0);
    const double front = -10 + 5 * std::sqrt(1.4);
    CHECK(between.at(front - 1e-3).rho > 0);
    CHECK(between.at(front + 1e-9).rho == 0);
    CHECK(between.at(0).u == 0);
    const Riemann beside{{1, 0, 1}, {0, 0, 0}, 1.4};
    CHECK(beside.at(5 * std::sqrt(1.4) + 1e-9).rho == 0);
    CHECK(beside.at(0).v == Approx(2 / 2.4 * std::sqrt(1.4)).epsilon(1e-14));
    CHECK(between.waves().left.head == Approx(-10 - std::sqrt(1.4)).epsilon(1e-14));
    CHECK(between.waves().left.tail == Approx(front).epsilon(1e-14));
    CHECK(between.waves().right.tail == -between.waves().left.tail);
    CHECK(beside.waves().left.head == Approx(-std::sqrt(1.4)).epsilon(1e-14));
    CHECK(beside.waves().left.tail == Approx(5 * std::sqrt(1.4)).epsilon(1e-14));
    CHECK(beside.waves().right.head == beside.waves().left.tail);  // no wave on the empty side
    CHECK(beside.waves().right.tail == beside.waves().left.tail);
    const Riemann mirror{{0, 0, 0}, {1, 0, 1}, 1.4};
    CHECK(mirror.waves().left.head == -beside.waves().left.tail);
    for (const double xi : {-6.0, -3.0, -0.5, 0.5, 2.0}) {
        CHECK(mirror.at(xi).rho == beside.at(-xi).rho);
        CHECK(mirror.at(xi).v == -beside.at(-xi).v);
    }
}

TEST_CASE("riemann: what has no meaning is refused by name") {
    CHECK_THROWS_WITH((Riemann{{1, 0, 1}, {1, 0, 1}, 1}), Catch::Contains("gamma"));
    CHECK_THROWS_WITH((Riemann{{-1, 0, 1}, {1, 0, 1}, 1.4}), Catch::Contains("rho"));
    CHECK_THROWS_WITH((Riemann{{1, std::nan(""), 1}, {1, 0, 1}, 1.4}), Catch::Contains("v"));
    CHECK_THROWS_WITH((Riemann{{0, 0, 1}, {1, 0, 1}, 1.4}), Catch::Contains("vacuum"));
    CHECK_THROWS_WITH((Riemann{{0, 0, 0}, {0, 0, 0}, 1.4}), Catch::Contains("both sides"));
}

TEST_CASE("exact riemann: header, columns, and refusals") {
    using namespace exact_program;
    const auto all =
        lines(run("riemann --left 1,-2,0.4 --right=1,2,0.4 --gamma 1.4 --time 0.15 --x -0.1,0,0.1").text);
    REQUIRE(all.size() == 7 + 3);
    CHECK(all[0] == "# gamma=1.3999999999999999");
    CHECK(all[2].rfind("# p_star=0.00189387342005", 0) == 0);
    CHECK(all[3].rfind("# v_star=", 0) == 0);
    CHECK(all[4].rfind("# rho_star_left=0.02185211820681", 0) == 0);
    CHECK(all[6] == "x,rho,v,p,u");
    const Riemann::Point point = Riemann{{1, -2, 0.4}, {1, 2, 0.4}, 1.4}.at(0.1, 0.15);
    CHECK(numbers(all[9]) == std::vector<double>{0.1, point.rho, point.v, point.p, point.u});
    CHECK(run("riemann --left 1,0 --right 1,0,1 --x 0").status == 2);
    CHECK(run("riemann --left -1,0,1 --right 1,0,1 --x 0").status == 2);
    CHECK(run("riemann --left 0,0,0 --right 0,0,0 --x 0").status == 2);
    CHECK(run("riemann --left 1,0,1 --right 1,0,nan --x 0").status == 2);
}
