#include "common/report/text.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

using report::Blocks;
using report::differences;
using report::fill;
using report::number;
using Lines = std::vector<std::string>;

TEST_CASE("numbers with significant digits") {
    // Fails if digits are counted after the point, if a carry shifts the exponent unnoticed (9.99), or if
    // zeros that were not measured are printed (12345).
    CHECK(number(0.0123, 2) == "0.012");
    CHECK(number(1.23e-5, 2) == "1.2e-5");
    CHECK(number(0.00123, 2) == "0.0012");
    CHECK(number(0.000123, 2) == "1.2e-4");
    CHECK(number(1, 3) == "1.00");
    CHECK(number(9.99, 2) == "10");
    CHECK(number(0.0999, 2) == "0.10");
    CHECK(number(12345, 2) == "1.2e4");
    CHECK(number(12000, 2) == "12000");
    CHECK(number(12000, 5) == "12000");
    CHECK(number(123.456, 4) == "123.5");
    CHECK(number(-0.5, 1) == "-0.5");
    CHECK(number(1e8, 1) == "1e8");
    CHECK(number(0.1, 17) == "0.10000000000000001");
    CHECK(number(5e-324, 2) == "4.9e-324");
    CHECK(number(std::numeric_limits<double>::max(), 2) == "1.8e308");
    CHECK(number(0, 3) == "0");
    CHECK(number(-0.0, 3) == "0");
    CHECK(number(std::nan(""), 2) == "nan");
    CHECK(number(-std::numeric_limits<double>::infinity(), 2) == "-inf");
    // Fails if a timing falls back to powers of ten below a million, or if fixed() keeps the sign of a zero.
    CHECK(report::timing(0.0123) == "≈0.012");
    CHECK(report::timing(2.44) == "≈2.4");
    CHECK(report::timing(237.4) == "≈240");
    CHECK(report::timing(15312) == "≈15000");
    CHECK(report::timing(9.99) == "≈10.0");
    CHECK(report::timing(3.1e7) == "≈3.1e7");
    CHECK(report::fixed(1.996, 2) == "2.00");
    CHECK(report::fixed(-0.004, 1) == "0.0");
    CHECK(report::fixed(-1.02, 1) == "-1.0");
    CHECK_THROWS_AS(number(1, 0), std::invalid_argument);
    CHECK_THROWS_AS(number(1, 18), std::invalid_argument);
}

TEST_CASE("what labels write as formulas is a formula in a table") {
    // Fails if a figure's $x$ comes through, or if a formula of a text is marked twice.
    report::Table table{{"gradient of $v$", "$`P`$"}};
    table.row({"$h$ = $s$", "1"});
    CHECK_THAT(table.markdown(),
               Catch::Contains("| gradient of $`v`$ | $`P`$ |") && Catch::Contains("| $`h`$ = $`s`$"));
}

TEST_CASE("tables") {
    // Fails if bytes are counted for letters, if a bar in a cell is not escaped, or if numbers are
    // left-aligned, those that bound a time too: which ones do hangs on the machine.
    report::Table table{{"method", "|x|", "s", "ms"}};
    table.row({"SPH", "0.12", "≈1.5", "≤ ≈2"});
    table.row({"Godunov", "12", "-", "–"});
    CHECK(table.markdown() ==
          "| method  | \\|x\\| |    s |   ms |\n"
          "| ------- | ----: | ---: | ---: |\n"
          "| SPH     |  0.12 | ≈1.5 | ≤ ≈2 |\n"
          "| Godunov |    12 |    - |    – |\n");
    CHECK_THROWS_AS(table.row({"too", "short"}), std::invalid_argument);
    CHECK_THROWS_AS(report::Table{{}}, std::invalid_argument);
}

TEST_CASE("marked blocks are filled, again and again") {
    // Fails if a table is not set on lines of its own, or if filling twice adds lines.
    const std::string text =
        "The error is <!-- fill error -->?<!-- end --> here.\n<!-- fill table --><!-- end -->\nEnd.\n";
    const Blocks blocks{{"error", "0.012"}, {"table", "| a |\n| - |\n"}};
    const std::string filled = fill(text, blocks);
    CHECK(filled ==
          "The error is <!-- fill error -->0.012<!-- end --> here.\n"
          "<!-- fill table -->\n| a |\n| - |\n<!-- end -->\nEnd.\n");
    CHECK(fill(filled, blocks) == filled);
    CHECK(differences(filled, blocks).empty());
}

TEST_CASE("faulty markers are refused") {
    // Each line fails if its check is left out: a README would silently lose text or a number.
    const Blocks blocks{{"a", "1"}};
    CHECK_THROWS_WITH(fill("<!-- fill a -->1", blocks), "<!-- fill a --> has no <!-- end -->");
    CHECK_THROWS_WITH(fill("<!-- fill a -->1<!-- fill a -->2<!-- end -->", blocks),
                      "<!-- fill a --> has no <!-- end -->");
    CHECK_THROWS_AS(fill("<!-- fill a b -->1<!-- end -->", blocks), std::invalid_argument);
    CHECK_THROWS_AS(fill("<!-- fill  -->1<!-- end -->", blocks), std::invalid_argument);
    CHECK_THROWS_WITH(fill("<!-- fill a -->1<!-- end --><!-- fill b -->1<!-- end -->", blocks),
                      "nothing to put between <!-- fill b --> and its end");
    CHECK_THROWS_WITH(fill("no marker", blocks), "the text has no <!-- fill a -->");
    CHECK_THROWS_AS(fill("<!-- fill a --><!-- end -->", Blocks{{"a", "<!-- end -->"}}),
                    std::invalid_argument);
}

TEST_CASE("some of the blocks are filled, the others stay as they are") {
    // Fails if a block that was not computed is emptied, or if one that the text lacks is an error.
    const std::string text = "<!-- fill a -->1<!-- end --> and <!-- fill b -->2<!-- end -->";
    CHECK(report::refill(text, {{"b", "3"}, {"c", "4"}}) ==
          "<!-- fill a -->1<!-- end --> and <!-- fill b -->3<!-- end -->");
    CHECK(report::refill("no marker", {{"a", "1"}}) == "no marker");
    CHECK(report::refill(text, {}) == text);
    CHECK_THROWS_WITH(report::refill("<!-- fill a -->1", {}), "<!-- fill a --> has no <!-- end -->");
}

TEST_CASE("shares in per cent, and columns of numbers") {
    // Fails if per cent are not a hundred times the share, or if a digit is lost in a table for machines.
    CHECK(report::percent(0.0456) == "4.6");
    CHECK(report::percent(1) == "100");
    CHECK(report::csv_row({1, 0.1, -3}) == "1,0.10000000000000001,-3\n");
    const std::vector<double> x{1, 2}, rho{0.5, 1e300};
    CHECK(report::csv({{"x", x}, {"rho", rho}}) == "x,rho\n1,0.5\n2,1.0000000000000001e+300\n");
}

namespace {

/// The differences of one block.
Lines compared(const std::string& printed, const std::string& computed) {
    return differences("<!-- fill a -->" + printed + "<!-- end -->", Blocks{{"a", computed}});
}

}  // namespace

TEST_CASE("a number may differ by one unit of its last digit") {
    // Fails if numbers are compared as words, or with a tolerance of two units, or relative to their size.
    CHECK(compared("0.0123", "0.0123").empty());
    CHECK(compared("0.0123", "0.0124").empty());
    CHECK(compared("0.0123", "0.0125") == Lines{"a: 0.0123 is printed, 0.0125 computed"});
    CHECK(compared("0.0123", "0.0223").size() == 1);
    CHECK(compared("1.2e-5", "1.3e-5").empty());
    CHECK(compared("1.2e-5", "1.2e-4").size() == 1);
    CHECK(compared("1.2e-5", "-1.2e-5").size() == 1);
    CHECK(compared("1.2e+5", "1.2e5").empty());
    CHECK(compared("9.9", "10").empty());    // 9.949 and 9.951 to two digits
    CHECK(compared("1.0e2", "99").empty());  // 99.6 and 99.4
    CHECK(compared("1.0e-4", "9.9e-5").empty());
    CHECK(compared("0", "0.30").size() == 1);
    CHECK(compared("1.2", "nan").size() == 1);
    CHECK(compared("3.1e-16", "-2.2e-15").empty());  // rounding against rounding
    CHECK(compared("0", "4.4e-16").empty());
    CHECK(compared("0", "4.4e-12").size() == 1);
}

TEST_CASE("words must be equal, timings are not compared") {
    // Fails if digits inside a name count as numbers, or if "≈" does not protect the number behind it.
    CHECK(compared("SPH is 1.2 times", "SPH was 1.2 times").size() == 1);
    CHECK(compared("in 2D", "in 3D").size() == 1);
    CHECK(compared("wendland_c2", "wendland_c3").size() == 1);
    CHECK(compared("takes ≈0.12 s", "takes ≈35 s").empty());
    CHECK(compared("| ≤ ≈0.12 | ≈ no run |", "| ≈35 | ≤ ≈2 |").empty());  // bounds of times depend on times
    CHECK(compared("| – |", "| ≈35 |").size() == 1);
    CHECK(compared("takes ≈ 0.12 s", "takes ≈ 1.1e-5 s").empty());
    CHECK(compared("takes ≈0.12 s, error 0.5", "takes ≈0.3 s, error 0.7") ==
          Lines{"a: 0.5 is printed, 0.7 computed in \"takes ≈0.12 s, error 0.5\""});
    CHECK(compared("takes ≈0.12 s", "takes 0.12 s").size() == 1);
}

TEST_CASE("tables are compared cell by cell, whatever their widths") {
    // Fails if the blanks of a wider column count, or if a lost line does not.
    report::Table printed{{"n", "error"}}, computed{{"n", "error"}}, changed{{"n", "error"}};
    printed.row({"100", "9.9"});
    printed.row({"200", "2.5"});
    computed.row({"100", "10.0"});
    computed.row({"200", "2.5"});
    changed.row({"100", "9.9"});
    changed.row({"200", "2.7"});
    CHECK(compared(printed.markdown(), computed.markdown()).empty());
    CHECK(compared(printed.markdown(), changed.markdown()) ==
          Lines{"a: 2.5 is printed, 2.7 computed in \"| 200 | 2.5 |\""});
    CHECK(compared("| 1 |\n| 2 |\n", "| 1 |\n") == Lines{"a: 2 lines are printed, 1 computed"});
}

TEST_CASE("blocks that are missing on one side are found") {
    // Fails if only the names that both sides have are compared.
    const std::string text = "<!-- fill a -->1<!-- end --> <!-- fill b -->2<!-- end -->";
    CHECK(differences(text, Blocks{{"a", "1"}, {"c", "3"}}) ==
          Lines{"b: stands in the text, but is not computed",
                "c: is computed, but does not stand in the text"});
    CHECK(differences("<!-- fill a -->1", Blocks{{"a", "1"}}) ==
          Lines{"<!-- fill a --> has no <!-- end -->"});
}
