// The command `exact landau`.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "common/exact/landau.hpp"
#include "tests/common/exact/exact_program.hpp"

using exact_program::check_refused;
using exact_program::constant;
using exact_program::lines;
using exact_program::numbers;
using exact_program::run;

// Every digit of the doubles. Fails if the option does not reach the solution, for exchanged columns, and for
// other defaults.
TEST_CASE("exact landau: header and states") {
    for (const std::string time : {"0", "0.75", "2.5"}) {
        const auto all = lines(run("landau --time " + time + " --x -1.3,0,0.1,2.5,99").text);
        REQUIRE(all.size() == 4 + 5);
        const exact::LandauSlab slab{std::stod(time)};
        CHECK(all[0] == "# time=" + time);
        CHECK(constant(all[1], "edge") == slab.edge());
        CHECK(constant(all[2], "matching") == slab.matching());
        CHECK(all[3] == "x,s_star,eps,rapidity,temperature");
        const double x[] = {-1.3, 0, 0.1, 2.5, 99};
        for (std::size_t k = 0; k < 5; ++k) {
            const auto state = slab.at(x[k]);
            CHECK(numbers(all[k + 4]) ==
                  std::vector<double>{x[k], state.s_star, state.eps, state.rapidity, state.temperature});
        }
    }
    CHECK(run("landau --time 4 --points 9").text == run("landau --points 9 --window 0,5").text);
    CHECK(lines(run("landau --time 1e6 --x 1e300").text).back() == "1.0000000000000001e+300,0,0,0,0");
}

// Fails for every check that is left out.
TEST_CASE("exact landau: bad usage is one line that names the mistake, status 2") {
    check_refused({
        {"landau", "--x", "--points"},
        {"landau --x 0 --time -1", "--time: -1", "0..1e6"},
        {"landau --x 0 --time 1000001", "--time: 1000001", "0..1e6"},
        {"landau --x 0 --time nan", "--time", "nan"},
        {"landau --x inf", "--x", "inf"},
        {"landau --points 3 --window 1,0", "--window", "a < b"},
    });
}
