// The form of a lesson: code, tables, objectives, hours, length, appendix; each rule broken once.
#include <catch2/catch.hpp>
#include <string>

#include "tests/lesson/sample.hpp"

using sample::after, sample::breaks, sample::keeps, sample::repeated, sample::with;

// Fails if three do, or if a marker without code counts.
TEST_CASE("a lesson shows at least four parts of its code") {
    const std::string marker = "<!-- code chapters/04_artificial_viscosity/dissipation.hpp force -->\n";
    breaks(with(marker, ""), "shows 3 parts");
    breaks(with(marker, marker + "\n"), "shows 3 parts");
    breaks(with(marker + "```cpp", marker + "```"), "shows 3 parts");
}

// Fails at seven or nine for eight rows.
TEST_CASE("a table before the appendix has at most eight rows") {
    const std::string row = "| signal | 0.01 |\n";
    keeps(with(row, repeated(row, 7)));
    breaks(with(row, repeated(row, 8)), ":38: a table of 9 rows");
    keeps(sample::text + repeated("| (4.1) | x | y |\n", 20));
}
TEST_CASE("a section before the appendix has at most one table") {
    const std::string table = "| a | b |\n|---|---|\n| 1 | 2 |\n";
    breaks(after("| signal | 0.01 |\n", "\nAnd\n\n" + table), ":45: a second table");
    breaks(after("| signal | 0.01 |\n", "<!-- end -->\n<!-- fill b -->\n" + table), "a second table");
    keeps(after("| signal | 0.01 |\n", "\n### More\n\n" + table));
    keeps(after("| signal | 0.01 |\n", "\n```\n" + table + "```\n"));
    keeps(sample::text + "\nAnd\n\n" + table);
}

// Fails at eleven or thirteen for twelve.
TEST_CASE("a lesson has at most twelve sections before its appendix") {
    std::string sections;
    for (int k = 0; k < 9; ++k) sections += "## More\n\n";
    keeps(with("## A viscosity\n", sections + "## A viscosity\n"));
    breaks(with("## A viscosity\n", sections + "## More\n\n## A viscosity\n"), "13 sections");
}

// Fails at two or four for three, and at four or six for five.
TEST_CASE("a lesson says what one can do after it: three to five things") {
    const std::string last = "- choose its strength.\n";
    breaks(with("After this chapter you can", "You can"), "no \"After this chapter you can\"");
    breaks(with(last, ""), "three to five items follow \"After this chapter you can\", not 2");
    breaks(after(last, repeated("- more\n", 3)), "not 6");
    breaks(after("## A viscosity\n", "\nAfter this chapter you can\n")
               .replace(sample::text.find("After this"), 26, "You can"),
           "no \"After");
    keeps(after(last, repeated("- more\n", 2)));
    keeps(with(last, "  - an item of an item\n" + last));
    keeps(after(last, repeated("- more\n", 2) + "  - an item of an item\n\nWords.\n\n- not of this list\n"));
}
TEST_CASE("a lesson says how long it takes") {
    breaks(with("Reading: about", "About"), "no line with");
    breaks(with("Running: two", "Two"), "no line with");
    breaks(after("## A viscosity\n", "\nReading: x. Running: y.\n")
               .replace(sample::text.find("Reading:"), 8, "About"),
           "no line with");
}

// Fails at 4498 or 4500 for the 4499 words that are allowed.
TEST_CASE("a lesson has fewer words than 4500 before its appendix") {
    const int missing = 4499 - lesson::word_count(sample::text);
    keeps(after("## A viscosity\n", "\n" + repeated("word\n", missing)));
    breaks(after("## A viscosity\n", "\n" + repeated("word\n", missing + 1)),
           ": 4500 words before the appendix");
    keeps(sample::text + "\n" + repeated("word\n", 5000));
}
TEST_CASE("words are counted outside code, comments, tables and displays") {
    CHECK(lesson::word_count(
              "# Two words\n\nOne – two (three): `four`, $`x`$.\n<!-- none\nnone --> six\n\n"
              "| none |\n\n```math\nnone\n```\n\n- seven\n\n> eight\n\n## Appendix A\n\nnone\n") == 10);
}

TEST_CASE("an appendix with the table of equations ends a lesson") {
    breaks(with("## Appendix", "## The end"), "no section \"## Appendix\"");
    breaks(with("### Where the equations are", "### Where all is"), "has no \"### ... equations ...\"");
    breaks(with("| equation | function | file |", "| equation | file | function |"), "with a table");
    breaks(sample::text + "\n## More\n", "a section behind the appendix");
    keeps(with("## Appendix", "## Appendix: tables"));
    keeps(with("### Where the equations are", "### Equations"));
}
