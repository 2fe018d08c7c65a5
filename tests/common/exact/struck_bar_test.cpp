// The struck bar and its command `exact bar`.
#include "common/exact/struck_bar.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/common/exact/exact_program.hpp"

using exact::StruckBar;

// Fails for another frequency, another normalisation, and for ends that are not fixed.
TEST_CASE("the struck bar obeys its equation") {
    const int masses = 12, struck = 4;
    const StruckBar bar{masses, struck, 0.3};
    const double t = 7.3, dt = 1e-3;
    for (int j = 1; j <= masses; ++j) {
        const double acceleration = (bar.velocity(j, t + dt) - bar.velocity(j, t - dt)) / (2 * dt);
        const double springs =
            bar.displacement(j + 1, t) - 2 * bar.displacement(j, t) + bar.displacement(j - 1, t);
        CHECK(std::abs(acceleration - springs) < 1e-6);  // 8e-8
        CHECK(std::abs(bar.displacement(j, 0)) < 1e-16);
        CHECK(std::abs(bar.velocity(j, 0) - (j == struck ? 0.3 : 0)) < 1e-15);  // 6e-17
    }
    CHECK(std::abs(bar.displacement(0, t)) < 1e-16);
    CHECK(std::abs(bar.displacement(masses + 1, t)) < 1e-15);  // 1e-16
}

// One mass is one spring: omega = sqrt(2). And energy is kept.
TEST_CASE("one mass swings with the frequency of two springs") {
    const StruckBar bar{1, 1, 2};
    CHECK(std::abs(bar.displacement(1, 5) - std::sqrt(2.0) * std::sin(std::sqrt(2.0) * 5)) < 1e-14);  // 2e-16
}

TEST_CASE("the struck bar refuses what has no meaning") {
    CHECK_THROWS_AS((StruckBar{0, 1, 1}), std::domain_error);
    CHECK_THROWS_AS((StruckBar{5, 6, 1}), std::domain_error);
    CHECK_THROWS_AS((StruckBar{5, 1, NAN}), std::domain_error);
    const StruckBar bar{5, 3, 1};
    CHECK_THROWS_AS(bar.displacement(7, 1), std::domain_error);
    CHECK_THROWS_AS(bar.velocity(1, -1), std::domain_error);
    CHECK_THROWS_AS(bar.frequency(6), std::domain_error);
}

TEST_CASE("exact bar: header and values, and bad usage in one line") {
    using namespace exact_program;
    const auto all = lines(run("bar --particles 7 --struck 2 --observed 5 --velocity -3 --time 0,1.5").text);
    REQUIRE(all.size() == 7);
    const std::string header[] = {"# particles=7", "# struck=2", "# observed=5", "# velocity=-3", "t,u,v"};
    for (std::size_t k = 0; k < 5; ++k) CHECK(all[k] == header[k]);
    const StruckBar bar{7, 2, -3};
    CHECK(numbers(all[6]) == std::vector<double>{1.5, bar.displacement(5, 1.5), bar.velocity(5, 1.5)});
    CHECK(run("bar --particles 7 --velocity 1e-3 --time 2").text ==
          run("bar --particles 7 --struck 4 --observed 4 --time 2").text);
    check_refused({{"bar", "--time", "missing"},
                   {"bar --time -1", "--time", "-1"},
                   {"bar --time 1 --particles 0", "--particles", "1..10000"},
                   {"bar --time 1 --particles 5 --struck 6", "--struck", "6"},
                   {"bar --time 1 --particles 5 --observed 6", "--observed", "6"},
                   {"bar --time 1 --velocity nan", "--velocity", "nan"}});
}
