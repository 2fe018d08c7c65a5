// Oblique shocks and fans, and the commands `exact oblique-shock` and `exact prandtl-meyer`.
#include "common/exact/steady_supersonic.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/common/exact/exact_program.hpp"

using exact::ObliqueShock;
using exact::PrandtlMeyer;
using exact_program::check_refused;
using exact_program::constant;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// How far mass, momenta and energy are from being conserved across the shock, relative to the flux ahead.
double worst_jump(const ObliqueShock& shock, double mach, double angle, double gamma) {
    struct Flow {
        double rho, across, along, p;
    };
    const double behind = shock.mach_behind() * std::sqrt(shock.p_ratio() / shock.rho_ratio());
    const Flow a{1, mach * std::sin(shock.beta()), mach * std::cos(shock.beta()), 1 / gamma};
    const Flow b{shock.rho_ratio(), behind * std::sin(shock.beta() - angle),
                 behind * std::cos(shock.beta() - angle), shock.p_ratio() / gamma};
    const auto energy = [&](const Flow& f) {
        return gamma / (gamma - 1) * f.p / f.rho + (f.across * f.across + f.along * f.along) / 2;
    };
    return std::max({std::abs(b.rho * b.across / (a.rho * a.across) - 1), std::abs(b.along - a.along) / mach,
                     std::abs((b.rho * b.across * b.across + b.p) / (a.across * a.across + a.p) - 1),
                     std::abs(energy(b) / energy(a) - 1)});
}

}  // namespace

// NACA Report 1135, tables and charts; the digits are those of its equations. Fails for the strong root, for
// an angle in degrees, and for exchanged ratios.
TEST_CASE("Oblique shock: values of the tables") {
    const ObliqueShock weak{2, 15 * degree, 1.4};
    CHECK(weak.beta() / degree == Approx(45.3436).epsilon(2e-6));
    CHECK(weak.mach_behind() == Approx(1.44572).epsilon(3e-6));
    CHECK(weak.p_ratio() == Approx(2.19465).epsilon(3e-6));
    CHECK(weak.rho_ratio() == Approx(1.72892).epsilon(3e-6));
    const ObliqueShock strong{2, 15 * degree, 1.4, ObliqueShock::Branch::strong};
    CHECK(strong.beta() / degree == Approx(79.8317).epsilon(2e-6));
    CHECK(ObliqueShock::largest_angle(2, 1.4) / degree == Approx(22.9735).epsilon(3e-6));
    // What a wedge of 15 degrees leaves cannot be turned back by another shock: a Mach stem.
    CHECK(ObliqueShock::largest_angle(1.44572, 1.4) / degree == Approx(10.67).epsilon(5e-4));
    const ObliqueShock normal{2, 0, 1.4, ObliqueShock::Branch::strong};
    CHECK(normal.mach_behind() == Approx(0.57735).epsilon(5e-6));
    CHECK(normal.p_ratio() == Approx(4.5).epsilon(1e-12));
    CHECK(ObliqueShock{3, 0, 1.4}.beta() == Approx(std::asin(1.0 / 3)).epsilon(1e-12));
    CHECK(ObliqueShock{3, 0, 1.4}.p_ratio() == Approx(1).epsilon(1e-12));
}

// Measured: 3e-14. Fails for any error in beta, in a ratio or in the Mach number behind.
TEST_CASE("Oblique shock: mass, momentum and energy pass it") {
    double worst = 0;
    for (const double gamma : {1.1, 1.4, 5.0 / 3, 3.0}) {
        for (const double mach : {1.05, 1.5, 3.0, 20.0}) {
            for (const double part : {0.1, 0.6, 0.99}) {
                const double angle = part * ObliqueShock::largest_angle(mach, gamma);
                for (const auto branch : {ObliqueShock::Branch::weak, ObliqueShock::Branch::strong})
                    worst = std::max(worst, worst_jump({mach, angle, gamma, branch}, mach, angle, gamma));
            }
        }
    }
    CHECK(worst < 1e-12);
}

// NACA Report 1135, table II. Fails for nu without one of its terms, and for a wrong exponent of P.
TEST_CASE("Prandtl-Meyer: values of the tables") {
    CHECK(PrandtlMeyer::nu(2, 1.4) / degree == Approx(26.3798).epsilon(2e-6));
    CHECK(PrandtlMeyer::nu(5, 1.4) / degree == Approx(76.9202).epsilon(2e-6));
    CHECK(PrandtlMeyer::nu(1, 1.4) == 0);
    CHECK(PrandtlMeyer::largest_angle(1, 1.4) / degree == Approx(130.454).epsilon(3e-6));
    const ObliqueShock shock{2, 15 * degree, 1.4};
    const PrandtlMeyer fan{shock.mach_behind(), 15 * degree, 1.4};
    CHECK(fan.mach_behind() == Approx(1.96151).epsilon(3e-6));
    // Both turns together lose what the shock made of entropy: the total pressure.
    const auto total = [](double p, double mach) { return p * std::pow(1 + 0.2 * mach * mach, 3.5); };
    CHECK(total(fan.p_ratio(), fan.mach_behind()) ==
          Approx(total(1, shock.mach_behind())).epsilon(1e-12));  // measured 4e-16
    CHECK(fan.rho_ratio() == Approx(std::pow(fan.p_ratio(), 1 / 1.4)).epsilon(1e-12));
    const PrandtlMeyer none{1.5, 0, 1.4};
    CHECK((none.mach_behind() == 1.5 && none.p_ratio() == 1));
}

// Fails for a ray on which the flow's own direction is forgotten.
TEST_CASE("Prandtl-Meyer: on a ray of the fan the wave stands still") {
    const double gamma = 1.4, ahead = 1.5;
    const PrandtlMeyer fan{ahead, 20 * degree, gamma};
    const double head = std::asin(1 / ahead), tail = std::asin(1 / fan.mach_behind()) - 20 * degree;
    CHECK(fan.mach_on_ray(head + 0.01) == ahead);
    CHECK(fan.mach_on_ray(tail - 0.01) == fan.mach_behind());
    for (const double part : {0.1, 0.5, 0.9}) {
        const double ray = head + part * (tail - head), mach = fan.mach_on_ray(ray);
        const double direction = PrandtlMeyer::nu(ahead, gamma) - PrandtlMeyer::nu(mach, gamma);
        CHECK(std::sin(ray - direction) == Approx(1 / mach).epsilon(1e-12));  // measured 2e-16
    }
}

// Fails for every check that is left out.
TEST_CASE("Oblique shock, Prandtl-Meyer: what there is none for is refused") {
    CHECK_THROWS_WITH((ObliqueShock{2, 23 * degree, 1.4}), Catch::Contains("0.400964"));
    CHECK_THROWS_AS((ObliqueShock{2, -0.1, 1.4}), std::domain_error);
    CHECK_THROWS_AS((ObliqueShock{1, 0, 1.4}), std::domain_error);
    CHECK_THROWS_AS((ObliqueShock{2, 0.1, 1}), std::domain_error);
    CHECK_THROWS_AS((ObliqueShock{std::nan(""), 0.1, 1.4}), std::domain_error);
    CHECK_THROWS_AS((PrandtlMeyer{2, 110 * degree, 1.4}), std::domain_error);
    CHECK_THROWS_AS((PrandtlMeyer{0.9, 0.1, 1.4}), std::domain_error);
}

// Fails for exchanged numbers, and for an option that does not reach the solution.
TEST_CASE("exact oblique-shock, prandtl-meyer: header and states") {
    const auto shock = lines(run("oblique-shock --mach 3 --angle 10 --gamma 5/3").text);
    REQUIRE(shock.size() == 3 + 5 + 2);
    const ObliqueShock solution{3, 10 * degree, 5.0 / 3};
    CHECK(constant(shock[0], "mach") == 3);
    CHECK(constant(shock[1], "angle") == 10);
    CHECK(constant(shock[2], "gamma") == 5.0 / 3);
    CHECK(constant(shock[3], "beta") == solution.beta() / degree);
    CHECK(constant(shock[4], "mach2") == solution.mach_behind());
    CHECK(constant(shock[5], "p_ratio") == solution.p_ratio());
    CHECK(constant(shock[6], "rho_ratio") == solution.rho_ratio());
    CHECK(constant(shock[7], "theta_max") == ObliqueShock::largest_angle(3, 5.0 / 3) / degree);
    CHECK(shock[8] == "beta,mach2,p_ratio,rho_ratio");
    CHECK(numbers(shock[9])[1] == solution.mach_behind());
    CHECK(constant(lines(run("oblique-shock --branch strong").text)[3], "beta") > 79);
    const auto fan = lines(run("prandtl-meyer --mach 3 --angle 10 --gamma 1.4").text);
    REQUIRE(fan.size() == 3 + 4 + 2);
    const PrandtlMeyer behind{3, 10 * degree, 1.4};
    CHECK(constant(fan[3], "nu") == PrandtlMeyer::nu(3, 1.4) / degree);
    CHECK(constant(fan[4], "mach2") == behind.mach_behind());
    CHECK(constant(fan[5], "p_ratio") == behind.p_ratio());
    CHECK(constant(fan[6], "rho_ratio") == behind.rho_ratio());
    CHECK(fan[7] == "nu2,mach2,p_ratio,rho_ratio");
}

// Fails for every check that is left out.
TEST_CASE("exact oblique-shock, prandtl-meyer: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"oblique-shock --mach 2 --angle 23", "--angle: 23", "22.9735 (theta_max at Mach 2)"},
        {"oblique-shock --mach 1", "--mach", "1"},
        {"oblique-shock --angle -1", "--angle", "-1"},
        {"oblique-shock --gamma 1", "--gamma", "1"},
        {"oblique-shock --branch steep", "--branch", "strong"},
        {"prandtl-meyer --mach 0.5", "--mach", "0.5"},
        {"prandtl-meyer --mach 2 --angle 105", "--angle: 105", "104.074"},
        {"prandtl-meyer --mach nan", "--mach", "nan"},
    });
}
