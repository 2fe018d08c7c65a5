// TwoLayer, plane flow of two fluids, and the command `exact two-layer`.
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/exact/two_layer.hpp"
#include "tests/common/exact/derivatives.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact::TwoLayer;
using exact_program::check_refused;
using exact_program::constant;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;
using finite_difference::derivatives;

namespace {

constexpr TwoLayer::Problem mixed{.lower_viscosity = 0.3,
                                  .upper_viscosity = 2,
                                  .interface = 0.3,
                                  .height = 2.5,
                                  .speed = 1.7,
                                  .force = 0.9};

std::string message_of(const TwoLayer::Problem& problem, double y = 0.5) {
    try {
        TwoLayer{problem}.at(y);
    } catch (const std::domain_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

// tau = mu dv/dy and dtau/dy = -force inside each layer, over the stress and over the force. Measured:
// 4e-14 and 2e-12, of the differences. Fails for exchanged viscosities, a force of the other sign, y for y/2.
TEST_CASE("TwoLayer: the Navier-Stokes equations in each layer") {
    const TwoLayer flow{mixed};
    for (const double y : {0.2, 0.6, 0.9, 1.7, 2.3}) {
        const double mu = y < 0.75 ? 0.3 : 2;
        const auto v = derivatives(0.03, [&](double s) { return flow.at(y + s).v; });
        const auto tau = derivatives(0.03, [&](double s) { return flow.at(y + s).tau; });
        CHECK(mu * v.first == Approx(flow.at(y).tau).epsilon(1e-12));
        CHECK(mu * v.second == Approx(-0.9).epsilon(1e-10));
        CHECK(tau.first == Approx(-0.9).epsilon(1e-12));
    }
}

// No slip at walls and interface, and one stress on both sides. Measured: rounding. Fails if the layers are
// weighed side by side (a wall stress with mu_1 s + mu_2 (1 - s)), or the upper one begins at the lower wall.
TEST_CASE("TwoLayer: walls and interface") {
    for (const double interface : {0.01, 0.3, 0.9}) {
        for (const double force : {0.0, 0.9, -40.0}) {
            auto problem = mixed;
            problem.interface = interface, problem.force = force;
            const TwoLayer flow{problem};
            CHECK(flow.at(0).v == 0);
            CHECK(flow.at(2.5).v == 1.7);
            const double y = interface * 2.5;
            const auto below = flow.at(std::nextafter(y, 0.0)), above = flow.at(std::nextafter(y, 2.5));
            CHECK(below.v == Approx(above.v).epsilon(1e-13));
            CHECK(below.tau == Approx(above.tau).epsilon(1e-13));
        }
    }
}

// Couette flow: slopes as 1/mu, tau the same everywhere, 2 mu_1 mu_2/(mu_1 + mu_2) for layers of equal
// thickness. Fails for the arithmetic mean of the viscosities, and for a stress with the height forgotten.
TEST_CASE("TwoLayer: Couette flow has one stress") {
    const TwoLayer flow{{.lower_viscosity = 1, .upper_viscosity = 10, .height = 2, .speed = 3}};
    for (const double y : {0.0, 0.7, 1.0, 2.0})
        CHECK(flow.at(y).tau == Approx(20.0 / 11 * 3 / 2).epsilon(1e-15));
    CHECK(flow.at(1).v == Approx(3 * 10.0 / 11).epsilon(1e-15));
    CHECK(flow.at(0.5).v == Approx(3 * 5.0 / 11).epsilon(1e-15));
}

// One fluid: v = V y/H + f y (H - y)/(2 mu), wherever the "interface". Measured: 2e-16. Fails for f/mu, and
// if the interface's place reaches the flow in any other way than by the viscosities.
TEST_CASE("TwoLayer: equal viscosities make one fluid") {
    for (const double interface : {1e-3, 0.5, 0.8}) {
        const TwoLayer flow{{.lower_viscosity = 0.7,
                             .upper_viscosity = 0.7,
                             .interface = interface,
                             .height = 2,
                             .speed = 1.5,
                             .force = 3}};
        for (const double y : {0.3, 1.0, 1.9})
            CHECK(flow.at(y).v == Approx(1.5 * y / 2 + 3 * y * (2 - y) / 1.4).epsilon(1e-14));
    }
}

// Poiseuille flow: the walls take what the force gives, and of a layer that hardly flows the other one sees a
// wall: f y (h - y)/(2 mu). Fails for a stress that is symmetric whatever the layers are.
TEST_CASE("TwoLayer: Poiseuille flow, and a layer as stiff as a wall") {
    auto problem = mixed;
    problem.speed = 0;
    const TwoLayer flow{problem};
    CHECK(flow.at(0).tau - flow.at(2.5).tau == Approx(0.9 * 2.5).epsilon(1e-14));
    CHECK(flow.at(0).tau + flow.at(2.5).tau < -0.1);  // measured: -0.99
    problem.upper_viscosity = 1e20;
    for (const double y : {0.1, 0.4, 0.7})
        CHECK(TwoLayer{problem}.at(y).v == Approx(0.9 * y * (0.75 - y) / 0.6).epsilon(1e-13));
}

// Fails for every check that is left out, and for a comparison that lets NaN pass.
TEST_CASE("TwoLayer: what lies outside the range is named") {
    const double nan = std::nan("");
    CHECK(message_of({}).empty());
    CHECK_THAT(message_of({.lower_viscosity = 0}), Catch::Contains("lower viscosity = 0"));
    CHECK_THAT(message_of({.lower_viscosity = nan}), Catch::Contains("lower viscosity"));
    CHECK_THAT(message_of({.upper_viscosity = 1e31}), Catch::Contains("upper viscosity = 1e+31"));
    CHECK_THAT(message_of({.interface = 0}), Catch::Contains("interface = 0"));
    CHECK_THAT(message_of({.interface = 1}), Catch::Contains("interface = 1"));
    CHECK_THAT(message_of({.height = -1}), Catch::Contains("height = -1"));
    CHECK_THAT(message_of({.speed = nan}), Catch::Contains("speed"));
    CHECK_THAT(message_of({.force = -1e31}), Catch::Contains("force = -1e+31"));
    CHECK_THAT(message_of({}, -0.1), Catch::Contains("y = -0.1"));
    CHECK_THAT(message_of({}, nan), Catch::Contains("y ="));
    CHECK_THAT(message_of({.height = 0.25}), Catch::Contains("y = 0.5"));
}

// Every digit of the doubles. Fails if an option does not reach the solution, for exchanged columns, and for
// other defaults.
TEST_CASE("exact two-layer: header and values") {
    const auto all = lines(run("two-layer --lower-viscosity 0.25 --upper-viscosity 2 --interface 0.375 "
                               "--height 2.5 --speed 1.5 --force 0.75 --y 0,0.5,2.5")
                               .text);
    REQUIRE(all.size() == 8 + 3);
    const TwoLayer solution{{.lower_viscosity = 0.25,
                             .upper_viscosity = 2,
                             .interface = 0.375,
                             .height = 2.5,
                             .speed = 1.5,
                             .force = 0.75}};
    const std::string header[] = {"# lower_viscosity=0.25", "# upper_viscosity=2", "# interface=0.375",
                                  "# height=2.5",           "# speed=1.5",         "# force=0.75"};
    for (std::size_t k = 0; k < 6; ++k) CHECK(all[k] == header[k]);
    CHECK(constant(all[6], "interface_speed") == solution.at(0.9375).v);
    CHECK(all[7] == "y,v,tau");
    const double y[] = {0, 0.5, 2.5};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [v, tau] = solution.at(y[k]);
        CHECK(numbers(all[k + 8]) == std::vector<double>{y[k], v, tau});
    }
    CHECK(run("two-layer --lower-viscosity 1 --upper-viscosity 1 --interface 0.5 --height 1 --speed 1 "
              "--force 0 --points 9 --window 0,1")
              .text == run("two-layer --points 9").text);
}

// Fails for every check that is left out.
TEST_CASE("exact two-layer: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"two-layer", "--y", "--points"},
        {"two-layer --y 0 --lower-viscosity 0", "--lower-viscosity", "0"},
        {"two-layer --y 0 --upper-viscosity nan", "--upper-viscosity", "nan"},
        {"two-layer --y 0 --interface 1", "--interface", "1"},
        {"two-layer --y 0 --height -1", "--height", "-1"},
        {"two-layer --y 0 --speed 1e31", "--speed", "1e31"},
        {"two-layer --y 0 --force inf", "--force", "inf"},
        {"two-layer --y 1.5", "--y", "1.5"},
        {"two-layer --points 3 --window -1,1", "--window", "-1"},
    });
}
