// The commands `exact noh` and `exact sedov`.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "common/exact/noh.hpp"
#include "common/exact/sedov.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact_program::check_refused;
using exact_program::constant;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;

// Every digit of the doubles. Fails if an option does not reach the solution, for exchanged columns, and for
// other defaults.
TEST_CASE("exact noh: header and states") {
    const auto all = lines(
        run("noh --dimension 1 --gamma 1.4 --density 3 --speed 2 --time 0.75 --x -2.5,0,0.125,99").text);
    REQUIRE(all.size() == 11 + 4);
    const exact::Noh solution{1, 1.4, 3, 2};
    const std::string header[] = {"# dimension=1", "# gamma=1.3999999999999999", "# density=3", "# speed=2",
                                  "# time=0.75"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    CHECK(constant(all[5], "shock_position") == solution.shock_position(0.75));
    CHECK(constant(all[6], "shock_speed") == solution.shock_speed());
    CHECK(constant(all[7], "rho_post") == solution.post_shock().rho);
    CHECK(constant(all[8], "p_post") == solution.post_shock().p);
    CHECK(constant(all[9], "u_post") == solution.post_shock().u);
    CHECK(all[10] == "x,rho,v,p,u");
    const double x[] = {-2.5, 0, 0.125, 99};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [rho, v, p, u] = solution.at(x[k], 0.75);
        CHECK(numbers(all[k + 11]) == std::vector<double>{x[k], rho, v, p, u});
    }
    CHECK(run("noh --dimension 3 --gamma 1.6666666666666667 --density 1 --speed 1 --time 0.6 --points 9")
              .text == run("noh --points 9 --window 0,1").text);
}

// The same.
TEST_CASE("exact sedov: header and states") {
    const auto all = lines(
        run("sedov --dimension 2 --gamma 1.6 --energy 3 --density 2 --time 0.75 --r 0.01,0.5,0.9,99").text);
    REQUIRE(all.size() == 13 + 4);
    const exact::Sedov solution{2, 1.6, 3, 2};
    const auto post = solution.post_shock(0.75);
    const std::string header[] = {"# dimension=2", "# gamma=1.6000000000000001", "# energy=3", "# density=2",
                                  "# time=0.75"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    CHECK(constant(all[5], "alpha") == solution.alpha());
    CHECK(constant(all[6], "shock_radius") == solution.shock_radius(0.75));
    CHECK(constant(all[7], "shock_speed") == solution.shock_speed(0.75));
    CHECK(constant(all[8], "rho_post") == post.rho);
    CHECK(constant(all[9], "v_post") == post.v);
    CHECK(constant(all[10], "p_post") == post.p);
    CHECK(constant(all[11], "u_post") == post.u);
    CHECK(all[12] == "r,rho,v,p,u");
    const double r[] = {0.01, 0.5, 0.9, 99};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [rho, v, p, u] = solution.at(r[k], 0.75);
        CHECK(numbers(all[k + 13]) == std::vector<double>{r[k], rho, v, p, u});
    }
    CHECK(run("sedov --dimension 3 --gamma 1.4 --energy 1 --density 1 --time 1 --points 9").text ==
          run("sedov --points 9 --window 0.01,1.2").text);
    CHECK(run("sedov --dimension 1 --gamma 100 --r 0.1").status == 0);
    CHECK(run("sedov --gamma 6.9999999999 --r 0.1").status == 0);
}

// Fails for every check that is left out.
TEST_CASE("exact noh, sedov: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"noh", "--x", "--points"},
        {"noh --x 0 --dimension 4", "--dimension", "1..3"},
        {"noh --x 0 --dimension 1.5", "--dimension", "1.5"},
        {"noh --x 0 --gamma 1", "--gamma", "100"},
        {"noh --x 0 --gamma nan", "--gamma", "nan"},
        {"noh --x 0 --density 0", "--density", "0"},
        {"noh --x 0 --speed -1", "--speed", "-1"},
        {"noh --x 0 --time -1", "--time", "-1"},
        {"noh --x inf", "--x", "inf"},
        {"noh --x 0.5,-0.5", "--x: -0.5", "--dimension 3"},
        {"noh --dimension 2 --points 3 --window -1,1", "--window: -1", "--dimension 2"},
        {"sedov", "--r", "--points"},
        {"sedov --r 1 --dimension 0", "--dimension", "1..3"},
        {"sedov --r 1 --gamma 1", "--gamma", "1.001..100"},
        {"sedov --r 1 --gamma 7", "--gamma: 7", "below 7 for --dimension 3"},
        {"sedov --r 1 --gamma nan", "--gamma", "nan"},
        {"sedov --r 1 --energy 0", "--energy", "0"},
        {"sedov --r 1 --density inf", "--density", "inf"},
        {"sedov --r 1 --time 0", "--time", "0"},
        {"sedov --r 0", "--r", "> 0"},
        {"sedov --r -1", "--r", "-1"},
        {"sedov --r 1,0.01 --gamma 1.01", "--r: 0.01", "farther"},
        {"sedov --points 3 --window 0.01,1 --gamma 1.01", "--window: 0.01", "farther"},
    });
}
