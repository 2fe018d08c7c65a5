#include "common/report/survival.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "common/app/error.hpp"
#include "tests/common/report/fake_run.hpp"

using report::Survival;
using Rows = std::vector<std::string>;

namespace {

/// Finishes where there is an error.
double finish(std::optional<double> error) {
    if (!error) throw app::UnphysicalError{"u < 0"};
    return *error;
}

}  // namespace

TEST_CASE("which methods finish hard cases: a table, rows, and bars") {
    // Fails if a failure of one run ends the others, or if shares are of another number of runs.
    FakeRun run;
    Survival survival{{"vacuum", "blast"}, true};
    survival.contestant("naive", "naive form", 4, [](std::size_t k, std::size_t r) {
        return finish(k == 0 || r == 3 ? std::nullopt : std::optional{1e9});  // without a judge it passes
    });
    survival.contestant("cured", "with cure", 4, [](std::size_t, std::size_t) { return 0.1; });
    survival.record(run);
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
    survival.contestant("naive", "naive", 1, [](std::size_t, std::size_t) { return 1.0; });
    survival.record(run);
    CHECK(run.rows == Rows{"naive vacuum,1,finished,1.00,runs"});
    CHECK(survival.table().find("all") == std::string::npos);
}

TEST_CASE("a run that finishes has passed only if its error is at most twice the reference's") {
    // Fails if the bound is one for all runs, if what is judged before its reference is not judged, or if an
    // error that is not a number passes.
    FakeRun run;
    Survival survival{{"vacuum", "blast"}, true, report::Judge{"plain", 2}};
    const double reference[2][3] = {{0.1, 0.2, 0.4}, {1, 1, 1}};
    survival.contestant("naive", "naive form", 3, [](std::size_t k, std::size_t r) {
        return k == 0 ? 0.3 : r == 0 ? std::nan("") : finish(r == 1 ? std::nullopt : std::optional{2.0});
    });
    survival.contestant("plain", "reference", 3,
                        [&](std::size_t k, std::size_t r) { return reference[k][r]; });
    survival.record(run);
    CHECK(run.rows == Rows{"naive vacuum,3,finished,3.00,runs", "naive vacuum,3,passed,2.00,runs",
                           "naive blast,3,finished,2.00,runs", "naive blast,3,passed,1.00,runs",
                           "naive all,6,finished,5.00,runs", "naive all,6,passed,3.00,runs",
                           "plain vacuum,3,finished,3.00,runs", "plain vacuum,3,passed,3.00,runs",
                           "plain blast,3,finished,3.00,runs", "plain blast,3,passed,3.00,runs",
                           "plain all,6,finished,6.00,runs", "plain all,6,passed,6.00,runs"});
    report::Table expected{{"runs passed", "vacuum", "blast", "all", "finished, but wrong"}};
    expected.row({"naive form", "2/3", "1/3", "3/6", "2"});
    expected.row({"reference", "3/3", "3/3", "6/6", "0"});
    CHECK(survival.table() == expected.markdown());
    const plot::Figure figure = survival.figure("hard");
    CHECK(figure.panels.front().bands[0].x.back() == 50);  // passed ones, not the 83 % that finished
    CHECK(survival.all_of("naive").wrong() == 2);
    CHECK(survival.count("naive", "blast").finished == 2);
    CHECK_THROWS_AS(survival.all_of("other"), std::out_of_range);
    CHECK_THROWS_AS(survival.count("naive", "tube"), std::out_of_range);
}

TEST_CASE(
    "where the reference does not finish, whoever does is right; without a reference nobody is judged") {
    Survival survival{{"vacuum"}, false, report::Judge{"plain", 2}};
    survival.contestant("naive", "naive", 1, [](std::size_t, std::size_t) { return 1e9; });
    CHECK_THROWS_AS(survival.table(), std::out_of_range);
    survival.contestant("plain", "plain", 1, [](std::size_t, std::size_t) { return finish({}); });
    CHECK(survival.count("naive", "vacuum").passed == 1);
    CHECK(survival.count("plain", "vacuum").passed == 0);
}

TEST_CASE("a mistake of the program is not a failed run") {
    // Fails if every exception counts as a failure: a wrong name would look like an unstable method.
    Survival survival{{"vacuum"}, false};
    CHECK_THROWS_AS(
        survival.contestant("a", "a", 1,
                            [](std::size_t, std::size_t) -> double { throw std::out_of_range{"no column"}; }),
        std::out_of_range);
}
