// A clamped plate and a loaded beam, and the commands `exact plate` and `exact beam`.
#include <catch2/catch.hpp>
#include <cmath>

#include "common/exact/plate.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact::ClampedPlate;
using exact::LoadedBeam;
using exact::Plane;
using exact_program::check_refused;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;

// The first five of many tables (Blevins 1979, table 8-1). Fails for cos kL cosh kL = +1, the plate with two
// clamps (4.730).
TEST_CASE("wave numbers of a clamped plate solve cos kL cosh kL = -1") {
    const double known[] = {1.87510407, 4.69409113, 7.85475744, 10.99554073, 14.13716839};
    for (int mode = 1; mode <= 5; ++mode) {
        const double k = ClampedPlate::wave_number(mode);
        CHECK(k == Approx(known[mode - 1]).epsilon(1e-9));
        CHECK(std::abs(std::cos(k) + 1 / std::cosh(k)) < 1e-14);  // measured 2e-16
    }
    CHECK(ClampedPlate::wave_number(1000) == Approx(999.5 * std::acos(-1)).epsilon(1e-14));
}

// Fails for a sign in s, and for E in place of E/(1 - nu^2).
TEST_CASE("a clamped plate: its shape bends as the equation says, and its frequency is that of the shape") {
    const double H = 0.3, L = 2, E = 5, nu = 0.4, rho = 1.5;
    const ClampedPlate plate{H, L, E, nu, rho};
    for (int mode = 1; mode <= 3; ++mode) {
        CHECK(plate.shape(mode, 0) == 0);
        CHECK(std::abs(plate.shape(mode, L)) == Approx(2).epsilon(1e-9));
        const double d = 1e-2, x = 1.1;
        const auto phi = [&](double at) { return plate.shape(mode, at); };
        const double fourth =
            (phi(x - 2 * d) - 4 * phi(x - d) + 6 * phi(x) - 4 * phi(x + d) + phi(x + 2 * d)) /
            (d * d * d * d);
        const double D = E / (1 - nu * nu) * H * H * H / 12;
        // D phi'''' = rho H omega^2 phi; the difference quotient is off by (kd)^2/6, at most 1e-3 here.
        CHECK(D * fourth == Approx(rho * H * std::pow(plate.omega(mode), 2) * phi(x)).epsilon(2e-3));
        // free of moment and of shear at the end
        CHECK(std::abs(phi(L) - 2 * phi(L - d) + phi(L - 2 * d)) < 0.02 * std::abs(phi(d)));
    }
    const ClampedPlate narrow{H, L, E, nu, rho, Plane::stress};
    CHECK(narrow.omega(1) / plate.omega(1) == Approx(std::sqrt(1 - nu * nu)).epsilon(1e-14));
}

// Fails for 8 in place of 3, the load spread over the beam.
TEST_CASE("a loaded beam: w L^3/(3 D) at the end, clamped at the other, without moment under the load") {
    const LoadedBeam beam{0.5, 4, 3, 0.25, 1e-3};
    const double D = 3 / (1 - 0.0625) * 0.125 / 12;
    CHECK(beam.stiffness() == Approx(D).epsilon(1e-14));
    CHECK(beam.deflection(4) == Approx(1e-3 * 64 / (3 * D)).epsilon(1e-14));
    CHECK(beam.deflection(0) == 0);
    const double d = 1e-3;
    const auto curvature = [&](double x) {
        return (beam.deflection(x - d) - 2 * beam.deflection(x) + beam.deflection(x + d)) / (d * d);
    };
    CHECK(D * curvature(1) == Approx(1e-3 * 3).epsilon(1e-6));
    CHECK(D * curvature(3) == Approx(1e-3 * 1).epsilon(1e-6));
    CHECK_THROWS_AS(beam.deflection(4.1), std::domain_error);
    CHECK_THROWS_AS(beam.deflection(-1), std::domain_error);
}

TEST_CASE("exact plate, exact beam: header and values") {
    const auto plate = lines(run("plate --thickness 0.5 --length 4 --young 3 --poisson 0.25 --density 2 "
                                 "--modes 2 --plane stress")
                                 .text);
    REQUIRE(plate.size() == 7 + 2);
    CHECK(plate[0] == "# thickness=0.5");
    CHECK(plate[6] == "mode,omega");
    const ClampedPlate exact{0.5, 4, 3, 0.25, 2, Plane::stress};
    for (int mode = 1; mode <= 2; ++mode) {
        CHECK(numbers(plate[static_cast<std::size_t>(6 + mode)]) ==
              std::vector<double>{static_cast<double>(mode), exact.omega(mode)});
    }
    const auto beam =
        lines(run("beam --thickness 0.5 --length 4 --young 3 --poisson 0.25 --load 0.001 --x 0,2,4").text);
    REQUIRE(beam.size() == 8 + 3);
    CHECK(beam[7] == "x,deflection");
    const LoadedBeam loaded{0.5, 4, 3, 0.25, 0.001};
    CHECK(exact_program::constant(beam[6], "end_deflection") == loaded.deflection(4));
    CHECK(numbers(beam[9]) == std::vector<double>{2, loaded.deflection(2)});
}

TEST_CASE("exact plate, beam: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"plate --thickness 0", "--thickness", "0"},
        {"plate --length -1", "--length", "-1"},
        {"plate --young nan", "--young", "nan"},
        {"plate --poisson 0.6", "--poisson", "0.6"},
        {"plate --density 0", "--density", "0"},
        {"plate --modes 0", "--modes", "1..1000"},
        {"plate --plane sideways", "--plane", "sideways"},
        {"beam", "--x", "--points"},
        {"beam --x 0 --load inf", "--load", "inf"},
        {"beam --x 11", "--x", "11"},
    });
}
