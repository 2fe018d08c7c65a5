// Formulas: the rules about them, each broken once, and every formula of the texts.
#include "tests/lesson/rules/formulas.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/lesson/sample.hpp"

using sample::after, sample::breaks, sample::keeps, sample::with;

TEST_CASE("the sample lesson breaks no rule") {
    keeps(sample::text);
}

// Fails if the number of lines, the chapter, the order or the end of a display are not looked at.
TEST_CASE("a display is one line that ends with its number") {
    breaks(with("a_i = -\\sum_j", "a_i =\n-\\sum_j"), ":21: a display is one line");
    breaks(with("{ij} \\tag{4.1}\n", "{ij} \\tag{4.1} .\n"), "no \\tag, not with \\tag{4.1}");
    breaks(with("\\Pi_{ij} = -\\frac", "\\tag{4.2} \\Pi_{ij} = -\\frac", with(" \\tag{4.2}\n", "\n")),
           "no \\tag");
    breaks(with("\\tag{4.2}", "\\tag{4.3}"), "\\tag{4.3}, not with \\tag{4.2}");
    breaks(with("\\tag{4.2}", "\\tag{3.2}"), "\\tag{3.2}, not with \\tag{4.2}");
    keeps(after("\\tag{4.2}\n```\n", "\n> ```math\n> b \\tag{4.3}\n> ```\n"));
    keeps(after("(dissipation.hpp) |\n", "") + "\n```math\nb \\tag{4.3}\n```\n");  // the appendix goes on
}
TEST_CASE("the numbers of equations begin with the chapter's, from one") {
    const auto found = lesson::breaches(sample::text, "05_tensile_instability");
    CHECK(std::count_if(found.begin(), found.end(), [](const std::string& breach) {
              return breach.find("not with \\tag{5.") != std::string::npos;
          }) == 2);
}
TEST_CASE("a text without displays is no lesson") {
    breaks(
        with(
            "(4.1) and the strength of (4.2)", "strengths",
            with(
                "(4.1) alone", "alone",
                with(
                    "| (4.1)", "|",
                    with(
                        "| (4.2)", "|",
                        with("\n```math\n\\Pi_{ij} = -\\frac{K v_{sig} w}{\\bar\\rho_{ij}} \\tag{4.2}\n```\n",
                             "",
                             with("```math\na_i = -\\sum_j m_j \\Pi_{ij} \\nabla_i W_{ij} \\tag{4.1}\n```\n",
                                  "")))))),
        "no displayed equation");
}

// Fails if "$$" or "$x$" passes, or if code counts as a formula.
TEST_CASE("formulas stand between a dollar and a backtick, and not between two dollars") {
    breaks(after("## A viscosity\n", "\nIts strength is $$K$$.\n"), ": $$; a display is a fence");
    breaks(with("$`\\Pi_{ij} = 0`$", "$`\\Pi_{ij} = 0` dollars"), "belongs to no formula");
    breaks(after("## A viscosity\n", "\nFive \\$ and\n$5.\n"), ":46: a dollar");
    keeps(after("## A viscosity\n", "\nThe variable `$HOME`, ``$`x`$``, \\$ and $`K`$, $`a\nb`$.\n"));
}
TEST_CASE("macros that GitHub does not draw are refused") {
    breaks(with("\\Pi_{ij} = 0`$", "\\operatorname{div} v = 0`$"), "GitHub refuses \\operatorname");
    breaks(with("\\bar\\rho_{ij}", "\\mbox{density}"), "GitHub refuses \\mbox");
}

// Fails if references in tables or groups are not read, or those in code are.
TEST_CASE("a reference to an equation finds it") {
    breaks(after("## A viscosity\n", "\nSee\n(4.3).\n"), ":46: no equation has the number (4.3)");
    breaks(with("| (4.2) |", "| (4.1, 4.7) |"), "number (4.7)");
    breaks(with("(4.1) and", "(4.1)–(4.5) and"), "number (4.5)");
    keeps(after("## A viscosity\n",
                "\nMonaghan (2005, 4.9), `f(4.9)`, $`(4.9)`$, 4.9, (3.9), (4.9 m).\n```\nf(4.9);\n```\n"));
}

TEST_CASE("references and tags are read with their lines") {
    const auto blocks = lesson::blocks_of("See (1.2)\nand (3.4 and 3.5).\n\n```math\nx \\tag{1.2}\n```\n");
    const auto references = lesson::references_of(blocks);
    REQUIRE(references.size() == 3);
    CHECK((references[0].line == 1 && references[0].chapter == "1" && references[0].number == 2));
    CHECK((references[2].line == 2 && references[2].chapter == "3" && references[2].number == 5));
    const auto tags = lesson::tags_of(blocks);
    REQUIRE(tags.size() == 1);
    CHECK((tags[0].line == 4 && tags[0].chapter == "1" && tags[0].number == 2));
}

TEST_CASE("formulas are read from displays, lines, tables and quotes, and not from code or comments") {
    std::string all;
    for (const auto& formula :
         lesson::formulas_of("a $`b`$ and\n$`c`$ `$d$`\n| $`e`$ |\n> ```math\n> f\n> ```\n"
                             "```\n$`g`$\n```\n<!-- $`h`$ -->\n``$`i`$``\n# $`j`$\n"))
        all += std::to_string(formula.line) + formula.tex + " ";
    CHECK(all == "1b 2c 3e 4f 12j ");
}
