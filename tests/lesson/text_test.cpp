// How a text is taken apart.
#include "tests/lesson/rules/text.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace {

/// "kind line: text" of each block; h, p, i, t, f are the kinds.
std::string taken_apart(const std::string& markdown) {
    std::string all;
    for (const lesson::Block& block : lesson::blocks_of(markdown))
        all += "hpitf"[static_cast<int>(block.kind)] + std::to_string(block.line) + ": " +
               lesson::in_one_line(block.text) + "; ";
    return all;
}

}  // namespace

TEST_CASE("a text is taken apart into headings, paragraphs, pictures, tables and fences") {
    CHECK(taken_apart("# a\nb\nc\n\n![d](e)\nf\n| g |\n|---|\nh\n```cpp\ni\n\n```\n") ==
          "h1: a; p2: b c; i5: ![d](e); p6: f; t7: | g | |---|; p9: h; f10: i; ");
    CHECK(taken_apart("#a\n- b\n  c\n12. d\n> e\n> f\ng") ==
          "p1: #a; p2: - b c; p4: 12. d; p5: e f; p7: g; ");
}
TEST_CASE("a fence ends with as many backticks as it began with") {
    CHECK(taken_apart("````\n```\n# a\n```\n````\nb") == "f1: ``` # a ```; p6: b; ");
    CHECK(taken_apart("> ```math\n> a\n> ```\nb") == "f1: a; p4: b; ");
}
TEST_CASE("comments are no text, except in code, and end tables but no paragraphs") {
    CHECK(taken_apart("a <!-- b --> c `<!-- d -->`") == "p1: a c `<!-- d -->`; ");
    CHECK(taken_apart("a\n<!-- b -->\nc\n| d |\n<!-- e -->\n| f |") == "p1: a c; t4: | d |; t6: | f |; ");
    CHECK(taken_apart("<!--\n```\n# a\n-->\nb") == "p5: b; ");
}
TEST_CASE("a section ends before the next heading of its level or above") {
    const auto blocks = lesson::blocks_of("# a\n## b\nc\n### d\n## e\n# f\ng\n");
    const auto sections = lesson::sections_of(blocks, 2);
    REQUIRE(sections.size() == 2);
    CHECK((sections[0].title == "b" && sections[0].line == 2 && sections[0].blocks.size() == 2));
    CHECK((sections[1].title == "e" && sections[1].blocks.empty()));
    CHECK(lesson::opening_of(blocks).size() == 1);
}
TEST_CASE("code and formulas inside lines are told from words") {
    const lesson::Inline found = lesson::inside("`a``b` c $`d`$\n``e`f`` $ `g");
    CHECK(found.codes == std::vector<std::string>{"a``b", "e`f"});
    REQUIRE(found.formulas.size() == 1);
    CHECK((found.formulas[0].first == 0 && found.formulas[0].second == "d"));
    CHECK(found.dollars == std::vector<int>{1});
    CHECK(lesson::in_one_line(found.words) == "c $ `g");
}
