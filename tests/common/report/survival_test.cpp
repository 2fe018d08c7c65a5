#include "common/report/survival.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "common/app/error.hpp"
#include "tests/common/report/fake_run.hpp"

using report::Survival;
using Rows = std::vector<std::string>;

TEST_CASE("which methods finish hard cases: a table, rows, and bars") {
    // Fails if a failure of one run ends the others, or if shares are of another number of runs.
    FakeRun run;
    Survival survival{{"vacuum", "blast"}, true};
    survival.contestant(run, "naive", "naive form", 4, [](std::size_t k, std::size_t r) {
        if (k == 0 || r == 3) throw app::UnphysicalError{"u < 0"};
    });
    survival.contestant(run, "cured", "with cure", 4, [](std::size_t, std::size_t) {});
    CHECK(run.rows == Rows{"naive vacuum,4,finished,0,runs", "naive blast,4,finished,3.00,runs",
                           "naive all,8,finished,3.00,runs", "cured vacuum,4,finished,4.00,runs",
                           "cured blast,4,finished,4.00,runs", "cured all,8,finished,8.00,runs"});
    report::Table expected{{"runs finished", "vacuum", "blast", "all"}};
    expected.row({"naive form", "0/4", "3/4", "3/8"});
    expected.row({"with cure", "4/4", "4/4", "8/8"});
    CHECK(survival.table() == expected.markdown());
    const plot::Figure figure = survival.figure("hard");
    CHECK(figure.name == "hard");
    const plot::Panel& panel = figure.panels.front();
    CHECK(panel.y.tick_names == Rows{"naive form", "with cure"});
    REQUIRE(panel.bands.size() == 2);
    CHECK(panel.bands[0].x.back() == 37.5);
    CHECK(panel.bands[1].x.back() == 100);
    CHECK(plot::faults(figure).empty());
}

TEST_CASE("without a total there is none") {
    FakeRun run;
    Survival survival{{"vacuum"}, false};
    survival.contestant(run, "naive", "naive", 1, [](std::size_t, std::size_t) {});
    CHECK(run.rows == Rows{"naive vacuum,1,finished,1.00,runs"});
    CHECK(survival.table().find("all") == std::string::npos);
}

TEST_CASE("a mistake of the program is not a failed run") {
    // Fails if every exception counts as a failure: a wrong name would look like an unstable method.
    FakeRun run;
    Survival survival{{"vacuum"}, false};
    CHECK_THROWS_AS(
        survival.contestant(run, "a", "a", 1,
                            [](std::size_t, std::size_t) { throw std::out_of_range{"no column"}; }),
        std::out_of_range);
}
