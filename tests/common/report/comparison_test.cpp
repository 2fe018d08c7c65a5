#include "common/report/comparison.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/common/report/fake_run.hpp"

using namespace report;
using Rows = std::vector<std::string>;

TEST_CASE("what runs measured, as rows of results.csv and as a table of part of it") {
    // Fails if a column shows another quantity, if a row is lost, or if an unmeasured number is left out
    // silently.
    FakeRun run;
    Comparison table{{"method", "N"},
                     {{"error %", "l1_rho", in_percent()},
                      {"drift", "energy_drift", or_word(1e-12, "rounding", digits(1)), "–"},
                      {"steps", "steps", whole()},
                      {"ms", "cpu_seconds", time_in(1e-3)}}};
    const Quantities costs{{"steps", 1638}, {"cpu_seconds", 0.25, "s"}};
    table.add(run, "sph", 100, {"SPH", "100"},
              Quantities{{"l1_rho", 0.0123}, {"energy_drift", -1e-15}} + costs);
    table.show({"grid", "50"}, Quantities{{"l1_rho", 0.5}} + costs);
    table.add_words({"none", "100", "stops"});
    table.show({"noise", "50"}, Quantities{{"l1_rho", 0.5}, {"energy_drift", 0}} + costs, Digits::noisy);
    CHECK(run.rows == Rows{"sph,100,l1_rho,0.0123,1", "sph,100,energy_drift,-1.00e-15,1",
                           "sph,100,steps,1.64e3,1", "sph,100,cpu_seconds,0.250,s"});
    Table expected{{"method", "N", "error %", "drift", "steps", "ms"}};
    expected.row({"SPH", "100", "1.2", "rounding", "1638", "≈250"});
    expected.row({"grid", "50", "50", "–", "1638", "≈250"});
    expected.row({"none", "100", "stops", "", "", ""});
    expected.row({"noise", "50", "≈50", "rounding", "≈1638", "≈250"});
    CHECK(table.markdown() == expected.markdown());
    CHECK_THROWS_AS(table.show({"grid", "50"}, costs), std::out_of_range);
}

TEST_CASE("how a table shows numbers") {
    CHECK(digits(2)(0.01234) == "0.012");
    CHECK(digits(1, 100)(0.5) == "50");
    CHECK(decimals(1, 100)(0.1234) == "12.3");
    CHECK(or_word(1e-3, "small", digits(1))(-0.5) == "-0.5");
    CHECK(value_of({{"a", 1}, {"b", 2}}, "b") == 2);
}
