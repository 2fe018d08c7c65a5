#include <catch2/catch.hpp>
#include <string>

#include "common/exact/burgers.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact_program::errors_of;
using exact_program::lines;
using exact_program::run;

namespace {

struct Row {
    double x, u;
};
Row row(const std::string& line) {
    const auto values = exact_program::numbers(line);
    REQUIRE(values.size() == 2);
    return {values[0], values[1]};
}

}  // namespace

// Every digit of the doubles: fails with 16 significant digits, with exchanged columns, and if an option does
// not reach the solution.
TEST_CASE("exact burgers: parameters, header and values") {
    const auto result = run("burgers --viscosity 0.03 --time 0.7 --x -0.3,0.30000000000000004,1,1e-9");
    CHECK(result.status == 0);
    const auto all = lines(result.text);
    REQUIRE(all.size() == 7);
    CHECK(all[0] == "# viscosity=0.029999999999999999");
    CHECK(all[1] == "# time=0.69999999999999996");
    CHECK(all[2] == "x,u");
    const exact::Burgers solution{0.03};
    const double expected[] = {-0.3, 0.1 + 0.2, 1, 1e-9};
    for (std::size_t k = 0; k < 4; ++k) {
        const Row values = row(all[k + 3]);
        CHECK(values.x == expected[k]);
        CHECK(values.u == solution.velocity(expected[k], 0.7));
    }
}

// Fails with N instead of N - 1 intervals, and if b - a overflows.
TEST_CASE("exact burgers: equidistant points, both ends included") {
    const auto all = lines(run("burgers --points 11 --window -1,2").text);
    REQUIRE(all.size() == 3 + 11);
    CHECK(all[0] == "# viscosity=0.01");
    CHECK(all[1] == "# time=0.5");
    CHECK(row(all[3]).x == -1);
    CHECK(row(all[13]).x == 2);
    for (int k = 0; k < 11; ++k) {
        CHECK(row(all[static_cast<std::size_t>(k) + 3]).x == Approx(-1 + 0.3 * k).margin(1e-15));
    }
    CHECK(lines(run("burgers --points 2").text).size() == 3 + 2);
    CHECK(lines(run("burgers --points 3 --window -1e308,1e308").text).back().starts_with("1e+308,"));
}

// Fails if the options are narrower than the solution, or a parameter is not printed.
TEST_CASE("exact burgers: the ends of the ranges") {
    CHECK(run("burgers --viscosity 1e-3 --time 0 --x 0.5").text ==
          "# viscosity=0.001\n# time=0\nx,u\n0.5,1\n");
    CHECK(run("burgers --viscosity 10 --time 5 --x 0.5").status == 0);
    CHECK(run("burgers --viscosity 1e-4 --time 100 --points 5").status == 0);
    CHECK(run("burgers --viscosity=100 --time=100 --x=-1e300").status == 0);
}

// Fails for every check of Points::values that is left out, and for < replaced by <=.
TEST_CASE("exact: bad usage is one line that names the mistake, status 2, nothing on standard output") {
    struct Case {
        const char* words;
        const char* named;
    };
    const Case cases[] = {
        {"", "burgers"},
        {"burger --x 0", "did you mean burgers?"},
        {"riemann --points 3 --window 1e-9,1e-10", "--window: 1e-9,1e-10 is not allowed"},
        {"qqq", "burgers"},
        {"burgers", "--x"},
        {"burgers --x 0 --points 3", "--points"},
        {"burgers --x 0 --window 0,1", "--window"},
        {"burgers --window 0,1", "--window"},
        {"burgers --points 3 --window 1,0", "--window"},
        {"burgers --points 3 --window 1,1", "--window"},
        {"burgers --points 3 --window 1", "--window"},
        {"burgers --points 1", "--points"},
        {"burgers --points 2.5", "--points"},
        {"burgers --x inf", "--x"},
        {"burgers --x nan", "--x"},
        {"burgers --x 1,,2", "--x"},
        {"burgers --x ''", "--x"},
        {"burgers --x 0 --viscosity 0", "--viscosity"},
        {"burgers --x 0 --viscosity 9e-5", "--viscosity"},
        {"burgers --x 0 --viscosity 101", "--viscosity"},
        {"burgers --x 0 --time -1", "--time"},
        {"burgers --x 0 --time 101", "--time"},
        {"burgers --x 0 --tme 1", "did you mean --time?"},
        {"burgers --x 0 more", "more"},
    };
    for (const auto& [words, named] : cases) {
        CAPTURE(words);
        const auto errors = errors_of(words);
        CHECK(errors.status == 2);
        CHECK(lines(errors.text).size() == 1);
        CHECK_THAT(errors.text, Catch::StartsWith("error: ") && Catch::Contains(named));
        CHECK(run(words).text.empty());
    }
}

// Fails if a solution is not declared as a command.
TEST_CASE("exact --help lists the solutions, exact burgers --help its options") {
    const auto all = run("--help");
    CHECK(all.status == 0);
    for (const char* solution : {"burgers", "rarefaction", "toy-star"})
        CHECK_THAT(all.text, Catch::Contains(solution));
    const auto burgers = run("burgers --help");
    CHECK(burgers.status == 0);
    for (const char* option :
         {"--viscosity", "--time", "--x", "--points", "--window", "default 0.01", "0..100"})
        CHECK_THAT(burgers.text, Catch::Contains(option));
}

// Fails if the text is written without a check, or the stream never flushed.
TEST_CASE("exact: a full disk is reported with status 4") {
    const auto result = run("burgers --x 0", "2>&1 >/dev/full");
    CHECK(result.status == 4);
    CHECK(lines(result.text).size() == 1);
}
