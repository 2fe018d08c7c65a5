// The commands `exact taylor-green` and `exact shear-wave`.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "common/exact/shear_wave.hpp"
#include "common/exact/taylor_green.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact_program::check_refused;
using exact_program::constant;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;

// Every digit of the doubles. Fails if an option does not reach the solution, for exchanged columns, for
// other defaults, and for a grid that counts the period's end twice.
TEST_CASE("exact taylor-green: header and grid") {
    const auto all = lines(
        run("taylor-green --viscosity 0.25 --speed 3 --side 2 --density 5 --time 0.125 --points 4").text);
    REQUIRE(all.size() == 8 + 16);
    const exact::TaylorGreen solution{0.25, 3, 2, 5};
    const std::string header[] = {"# viscosity=0.25", "# speed=3", "# side=2", "# density=5", "# time=0.125"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    CHECK(constant(all[5], "decay_rate") == solution.decay_rate());
    CHECK(constant(all[6], "kinetic_energy") == solution.kinetic_energy(0.125));
    CHECK(all[7] == "x,y,v_x,v_y,p");
    for (std::size_t k = 0; k < 16; ++k) {
        const double x = 0.5 * double(k % 4), y = 0.5 * double(k / 4);
        const auto [v_x, v_y, p] = solution.at(x, y, 0.125);
        CHECK(numbers(all[k + 8]) == std::vector<double>{x, y, v_x, v_y, p});
    }
    CHECK(run("taylor-green --viscosity 0.01 --speed 1 --side 1 --density 1 --time 0 --points 50").text ==
          run("taylor-green").text);
}

// The same.
TEST_CASE("exact shear-wave: header and values") {
    const auto all =
        lines(run("shear-wave --viscosity 0.25 --speed 3 --side 2 --mode 2 --time 0.125 --x -0.3,0,7").text);
    REQUIRE(all.size() == 7 + 3);
    const exact::ShearWave solution{0.25, 3, 2, 2};
    const std::string header[] = {"# viscosity=0.25", "# speed=3", "# side=2", "# mode=2", "# time=0.125"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    CHECK(constant(all[5], "decay_rate") == solution.decay_rate());
    CHECK(all[6] == "x,v_y");
    const double x[] = {-0.3, 0, 7};
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(numbers(all[k + 7]) == std::vector<double>{x[k], solution.velocity(x[k], 0.125)});
    CHECK(run("shear-wave --viscosity 0.01 --speed 1 --side 1 --mode 1 --time 0 --points 9").text ==
          run("shear-wave --points 9 --window 0,1").text);
}

// Fails for every check that is left out.
TEST_CASE("exact taylor-green, shear-wave: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"taylor-green --viscosity -1", "--viscosity", "-1"},
        {"taylor-green --speed 0", "--speed", "0"},
        {"taylor-green --side nan", "--side", "nan"},
        {"taylor-green --density -1", "--density", "-1"},
        {"taylor-green --time inf", "--time", "inf"},
        {"taylor-green --points 0", "--points", "1..1000"},
        {"taylor-green --points 1001", "--points", "1..1000"},
        {"taylor-green --x 1", "--x", "error"},
        {"shear-wave", "--x", "--points"},
        {"shear-wave --x 0 --viscosity nan", "--viscosity", "nan"},
        {"shear-wave --x 0 --speed -1", "--speed", "-1"},
        {"shear-wave --x 0 --side 0", "--side", "0"},
        {"shear-wave --x 0 --mode 0", "--mode", "1..1000"},
        {"shear-wave --x 0 --mode 1.5", "--mode", "1.5"},
        {"shear-wave --x 0 --time -1", "--time", "-1"},
        {"shear-wave --x inf", "--x", "inf"},
    });
}
