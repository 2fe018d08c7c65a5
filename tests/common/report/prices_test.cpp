#include "common/report/prices.hpp"

#include <catch2/catch.hpp>

#include "tests/common/report/fake_run.hpp"

using report::Prices;
using Rows = std::vector<std::string>;

TEST_CASE("what listed effects cost a pair") {
    // Fails if the time is divided by particles instead of pairs, or if the pass is not run.
    FakeRun run;
    run.best = 2e-6;
    int passes = 0;
    Prices prices{true};
    prices.add(run, "density", {[&] { ++passes; }, 100, 1000, 5});
    run.best = 5e-6;
    prices.add(run, "all", {[&] { ++passes; }, 100, 1000, 12});
    CHECK(passes == 2);
    CHECK(run.rows == Rows{"density,100,cpu_ns_per_pair,2.00,ns", "density,100,columns,5.00,columns",
                           "all,100,cpu_ns_per_pair,5.00,ns", "all,100,columns,12.0,columns"});
    report::Table expected{{"listed", "columns of a particle", "ns a pair"}};
    expected.row({"density", "5", "≈2.0"});
    expected.row({"all", "12", "≈5.0"});
    CHECK(prices.table() == expected.markdown());
    const plot::Figure figure = prices.figure("cost", "in 3D");
    CHECK(figure.panels.front().title == "in 3D");
    CHECK(figure.panels.front().y.tick_names == Rows{"density", "all"});
    CHECK(figure.panels.front().bands[1].x.back() == Approx(5));
    CHECK(plot::faults(figure).empty());
}

TEST_CASE("columns are shown only where they are wanted") {
    FakeRun run;
    run.best = 1e-6;
    Prices prices{false};
    prices.add(run, "density", {[] {}, 10, 100, 5});
    CHECK(run.rows == Rows{"density,10,cpu_ns_per_pair,10.0,ns"});
    CHECK(prices.table().find("columns") == std::string::npos);
}
