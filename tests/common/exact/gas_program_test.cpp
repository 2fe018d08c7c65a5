// The commands `exact toy-star` and `exact rarefaction`.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "common/exact/rarefaction.hpp"
#include "common/exact/toy_star.hpp"
#include "common/exact/toy_star_modes.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact_program::check_refused;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;

// Every digit of the doubles. Fails for modes that are counted from 0, and if --gamma does not reach them.
TEST_CASE("exact toy-star --modes: header and frequencies") {
    const auto all = lines(run("toy-star --gamma 1.4 --modes 30").text);
    REQUIRE(all.size() == 2 + 30);
    CHECK(all[0] == "# gamma=1.3999999999999999");
    CHECK(all[1] == "mode,omega");
    CHECK(all[2] == "1,1");
    for (int mode = 1; mode <= 30; ++mode) {
        const auto row = numbers(all[static_cast<std::size_t>(mode) + 1]);
        CHECK(row == std::vector<double>{double(mode), exact::toy_star_frequency(1.4, mode)});
    }
    CHECK(lines(run("toy-star --gamma 100 --modes 1000").text).size() == 2 + 1000);
    CHECK(run("toy-star --modes 1").text == "# gamma=2\nmode,omega\n1,1\n");
}

// Fails if an option does not reach the star, for exchanged columns, and for other defaults.
TEST_CASE("exact toy-star --time: header and states") {
    const auto all = lines(run("toy-star --gamma 1.6 --k 0.5 --omega 2 --a0 -1 --h0 3 --c0 0.75 --time "
                               "-0.3,0,0.30000000000000004")
                               .text);
    REQUIRE(all.size() == 8 + 3);
    const std::string header[] = {
        "# gamma=1.6000000000000001", "# k=0.5", "# omega=2", "# a0=-1", "# h0=3", "# c0=0.75"};
    for (std::size_t k = 0; k < 6; ++k) CHECK(all[k] == header[k]);
    const exact::ToyStar star{1.6, 0.5, 2, -1, 3, 0.75};
    CHECK(numbers(all[6].substr(all[6].find('=') + 1))[0] == star.period());
    CHECK(all[7] == "t,A,H,C,radius");
    const double times[] = {-0.3, 0, 0.1 + 0.2};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto state = star.at(times[k]);
        CHECK(numbers(all[k + 8]) == std::vector<double>{times[k], state.A, state.H, state.C, state.radius});
    }
    const auto row = numbers(lines(run("toy-star --time 2").text).back());  // the shared table
    CHECK(row[1] == Approx(-0.79733272710545).epsilon(1e-13));
    CHECK(row[3] == Approx(0.59163852691696).epsilon(1e-13));
}

// Fails if an option does not reach the solution, for exchanged columns, and for other defaults.
TEST_CASE("exact rarefaction: header and states") {
    const auto all = lines(
        run("rarefaction --rho 3 --u 1.5 --gamma 1.6 --half-width 2 --time 0.75 --x -2.5,0,1.5,99").text);
    REQUIRE(all.size() == 9 + 4);
    const exact::Rarefaction solution{3, 1.5, 1.6, 2};
    const std::string header[] = {"# rho=3", "# u=1.5", "# gamma=1.6000000000000001", "# half_width=2",
                                  "# time=0.75"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    const auto constant = [&](std::size_t k, const std::string& name) {
        CHECK_THAT(all[k], Catch::StartsWith("# " + name + "="));
        return numbers(all[k].substr(all[k].find('=') + 1)).front();
    };
    CHECK(constant(5, "c0") == solution.sound_speed());
    CHECK(constant(6, "head") == solution.head(0.75));
    CHECK(constant(7, "front") == solution.front(0.75));
    CHECK(all[8] == "x,rho,v,p,u");
    const double x[] = {-2.5, 0, 1.5, 99};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [rho, v, p, u] = solution.at(x[k], 0.75);
        CHECK(numbers(all[k + 9]) == std::vector<double>{x[k], rho, v, p, u});
    }
    CHECK(run("rarefaction --rho 1 --u 2 --gamma 1.4 --half-width 0.5 --time 0.1 --points 9").text ==
          run("rarefaction --points 9 --window 0,1").text);
}

// Fails for every check that is left out.
TEST_CASE("exact toy-star, rarefaction: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"toy-star", "--modes", "--time"},
        {"toy-star --gamma 2", "--modes", "--time"},
        {"toy-star --modes 3 --time 1", "--modes", "--time"},
        {"toy-star --modes 3 --omega 2", "--omega", "--time"},
        {"toy-star --modes 3 --k 2", "--k", "--time"},
        {"toy-star --modes 3 --a0 2", "--a0", "--time"},
        {"toy-star --modes 3 --h0 2", "--h0", "--time"},
        {"toy-star --modes 3 --c0 2", "--c0", "--time"},
        {"toy-star --modes 0", "--modes", "1..1000"},
        {"toy-star --modes 1001", "--modes", "1..1000"},
        {"toy-star --modes 2.5", "--modes", "2.5"},
        {"toy-star --modes 3 --gamma 1", "--gamma", "100"},
        {"toy-star --modes 3 --gamma 100.1", "--gamma", "100.1"},
        {"toy-star --modes 3 --gamma nan", "--gamma", "nan"},
        {"toy-star --time 1 --gamma inf", "--gamma", "inf"},
        {"toy-star --time 1,inf", "--time", "inf"},
        {"toy-star --time 10001", "--time", "10001"},
        {"toy-star --time ''", "--time", ""},
        {"toy-star --time 1 --omega 0", "--omega", "0.001"},
        {"toy-star --time 1 --k -1", "--k", "-1"},
        {"toy-star --time 1 --a0 nan", "--a0", "nan"},
        {"toy-star --time 1 --h0 0", "--h0", "0"},
        {"toy-star --time 1 --c0 1e7", "--c0", "1e7"},
        {"toy-star --time 1 --gamma 1.1 --a0 -1e6", "--a0", "-1000000"},
        {"rarefaction", "--x", "--points"},
        {"rarefaction --x 0 --time 0.4725", "--time", "0.4725 is not allowed; allowed: 0..0.47245"},
        {"rarefaction --x 0 --time -1", "--time", "-1"},
        {"rarefaction --x 0 --time nan", "--time", "nan"},
        {"rarefaction --x 0 --rho 0", "--rho", "0"},
        {"rarefaction --x 0 --u inf", "--u", "inf"},
        {"rarefaction --x 0 --gamma 1", "--gamma", "100"},
        {"rarefaction --x 0 --half-width -1", "--half-width", "-1"},
        {"rarefaction --x nan", "--x", "nan"},
    });
}
