#include "common/plot/markup.hpp"

#include <catch2/catch.hpp>

using plot::decode_utf8;
using plot::parse_markup;
using plot::TextRun;
using Runs = std::vector<TextRun>;

namespace {

TextRun plain(std::u32string text) {
    return {std::move(text), false, {}, {}};
}
TextRun italic(std::u32string text) {
    return {std::move(text), true, {}, {}};
}

}  // namespace

TEST_CASE("UTF-8 becomes code points, what is not UTF-8 a sign for it") {
    CHECK(decode_utf8("aγ−𝄞") == U"aγ−𝄞");
    CHECK(decode_utf8("").empty());
    CHECK(decode_utf8("a\xff"
                      "b") == U"a\uFFFDb");
    CHECK(decode_utf8("\xc3") == U"\uFFFD");            // cut off
    CHECK(decode_utf8("\xc3(") == U"\uFFFD(");          // fails if the next letter is swallowed
    CHECK(decode_utf8("\xc0\xaf") == U"\uFFFD\uFFFD");  // overlong, 2 bytes
    CHECK(decode_utf8("\xe0\x80\xaf") == U"\uFFFD\uFFFD\uFFFD");
    CHECK(decode_utf8("\xed\xa0\x80") == U"\uFFFD\uFFFD\uFFFD");  // half of a surrogate pair
    CHECK(decode_utf8("\xf4\x90\x80\x80").front() == U'\uFFFD');  // beyond U+10FFFF
    CHECK(decode_utf8("a\n\tb\x7f") == U"a  b ");
}

TEST_CASE("text without markup is one run") {
    CHECK(parse_markup("").empty());
    CHECK(parse_markup("SPH, N = 50") == Runs{plain(U"SPH, N = 50")});
    CHECK(parse_markup("file_name^2 {x}") ==
          Runs{plain(U"file_name^2 {x}")});  // fails if a brace is not asked for
}

TEST_CASE("letters between dollars are italic, digits and signs are not") {
    CHECK(parse_markup("time $t$ = 2") == Runs{plain(U"time "), italic(U"t"), plain(U" = 2")});
    CHECK(parse_markup("$2γ − W$") == Runs{plain(U"2"), italic(U"γ"), plain(U" − "), italic(U"W")});
    CHECK(parse_markup("5 $ a") == Runs{plain(U"5 $ a")});
    CHECK(parse_markup("$a$ $") == Runs{italic(U"a"), plain(U" $")});
}

TEST_CASE("scripts hang on what stands before") {
    CHECK(parse_markup("10^{−3} s") == Runs{{U"10", false, {}, {plain(U"−3")}}, plain(U" s")});
    CHECK(parse_markup("x_{i}^{2}") == Runs{{U"x", false, {plain(U"i")}, {plain(U"2")}}});
    CHECK(parse_markup("x^{2}_{i}") == parse_markup("x_{i}^{2}"));
    CHECK(parse_markup("x_{a}_{b}") ==
          Runs{{U"x", false, {plain(U"a")}, {}}, {U"", false, {plain(U"b")}, {}}});
    CHECK(parse_markup("_{i}x") == Runs{{U"", false, {plain(U"i")}, {}}, plain(U"x")});
    CHECK(parse_markup("$v_{x}$") == Runs{{U"v", true, {italic(U"x")}, {}}});
    CHECK(parse_markup("$v$_{x}") == Runs{{U"v", true, {plain(U"x")}, {}}});
    CHECK(parse_markup("s_{$i$}") == Runs{{U"s", false, {italic(U"i")}, {}}});
    CHECK(parse_markup("e^{x_{i}}") == Runs{{U"e", false, {}, {{U"x", false, {plain(U"i")}, {}}}}});
}

TEST_CASE("markup that is not closed is text") {
    CHECK(parse_markup("x_{i") == Runs{plain(U"x_{i")});
    CHECK(parse_markup("x^") == Runs{plain(U"x^")});
    CHECK(parse_markup("x_{$i}$") == Runs{{U"x", false, {plain(U"$i")}, {}}, plain(U"$")});
    // The fourth script inside scripts is text: fails (in endless recursion for longer ones) without a limit.
    const Runs deep = parse_markup("^{^{^{^{x}}}}");
    CHECK(deep[0].above[0].above[0].above == Runs{plain(U"^{x}")});
    std::string hostile;
    for (int i = 0; i < 2000; ++i) hostile += "_{";
    CHECK_NOTHROW(parse_markup(hostile + std::string(2000, '}')));
}
