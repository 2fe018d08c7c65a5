#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "common/plot/canvas.hpp"
#include "tests/common/plot/picture.hpp"

using picture::black;
using picture::drawn;
using plot::Anchor;
using plot::Canvas;
using plot::Image;
using plot::Point;
using plot::TextStyle;
using plot::Vertical;

namespace {

Image written(Canvas& canvas, const std::string& text, const TextStyle& style, Point at = {200, 200}) {
    return drawn(canvas, 400, 400, [&](Canvas& c) { c.text(at, text, style); });
}

}  // namespace

TEST_CASE("ink stays inside the measured box and nearly fills its width") {
    Canvas canvas;
    for (const std::string text :
         {"Hamburg", "x", "$Wf$", "ρ_{exact}", "10^{−3}", "$x_{i}^{2}$", "(‖Q‖)", "e^{−x_{i}^{2}}"})
        for (const double size : {11.0, 20.0, 33.5}) {
            CAPTURE(text, size);
            const plot::TextSize extent = canvas.measure(text, size);
            const auto ink =
                picture::ink(written(canvas, text, {size, black, Anchor::left, Vertical::baseline, 0}));
            // One pixel more for smooth edges and hinting.
            CHECK(ink.left >= 199);
            CHECK(ink.right <= 200 + extent.width + 1);
            CHECK(ink.right - ink.left > extent.width - 0.3 * size);  // fails if a script is not counted
            CHECK(ink.top >= 200 - extent.ascent - 1.5);
            CHECK(ink.bottom <= 200 + extent.descent + 1);
        }
    CHECK(canvas.measure("", 20).width == 0);
    CHECK(canvas.measure("xx", 20).width == Approx(2 * canvas.measure("x", 20).width).epsilon(0.1));
    CHECK(canvas.measure("x", 40).width == Approx(2 * canvas.measure("x", 20).width).epsilon(1e-6));
    CHECK(canvas.measure("a", 20).ascent == canvas.measure("l", 20).ascent);
    CHECK(canvas.measure("AV", 20).width <
          canvas.measure("A", 20).width + canvas.measure("V", 20).width - 0.5);
}

TEST_CASE("text lies at its anchor") {
    Canvas canvas;
    const auto box = [&](Anchor horizontal, Vertical vertical, double angle) {
        return picture::ink(written(canvas, "HIH", {20, black, horizontal, vertical, angle}), 0.3);
    };
    // Fails if an alignment is taken for another: they differ by 7 pixels and more.
    CHECK(box(Anchor::left, Vertical::baseline, 0).left == Approx(201.5).margin(1.5));
    CHECK(box(Anchor::right, Vertical::baseline, 0).right == Approx(197.5).margin(1.5));
    CHECK(box(Anchor::centre, Vertical::baseline, 0).x == Approx(200).margin(0.5));
    CHECK(box(Anchor::left, Vertical::baseline, 0).bottom == 199);  // on the line, snapped
    CHECK(box(Anchor::left, Vertical::middle, 0).y == Approx(200).margin(0.6));
    CHECK(box(Anchor::left, Vertical::top, 0).top == Approx(200.5).margin(1.5));
    CHECK(box(Anchor::left, Vertical::bottom, 0).bottom == Approx(195).margin(1.5));
    // Upwards along a y axis: the top of the letters points to the left.
    CHECK(box(Anchor::left, Vertical::baseline, 90).bottom == Approx(198).margin(1.5));
    CHECK(box(Anchor::left, Vertical::baseline, 90).right == 199);
    CHECK(box(Anchor::centre, Vertical::bottom, 90).y == Approx(200).margin(0.6));
    CHECK(box(Anchor::centre, Vertical::bottom, 90).right == Approx(195).margin(1.5));
    CHECK(box(Anchor::left, Vertical::baseline, 180).top == 200);
}

TEST_CASE("turned text is the same text") {
    Canvas canvas;
    const std::string text = "Density ρ_{0} = $γ^{2}$";
    const auto written_at = [&](double angle) {
        return picture::ink(written(canvas, text, {20, black, Anchor::centre, Vertical::middle, angle}));
    };
    const auto level = written_at(0), upright = written_at(90), down = written_at(-90),
               around = written_at(360);
    // Hinted either way: the same pixels, but for the quarter of a pixel where the anchor falls.
    CHECK(upright.sum == Approx(level.sum).epsilon(0.005));
    CHECK(down.sum == Approx(level.sum).epsilon(0.005));
    CHECK(around.sum == level.sum);
    CHECK(upright.bottom - upright.top == Approx(level.right - level.left).margin(1));
    for (const double angle : {17.0, 45.0, 120.0, 200.0}) {
        CAPTURE(angle);
        CHECK(written_at(angle).sum == Approx(level.sum).epsilon(0.03));  // not hinted: a little thinner
        // The centre of the ink goes around with the text: fails if only the glyphs turn, or the other way.
        const Point offset{level.x - 200, level.y - 200};
        const double turn = angle * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
        CHECK(written_at(angle).x - 200 == Approx(c * offset.x + s * offset.y).margin(0.5));
        CHECK(written_at(angle).y - 200 == Approx(-s * offset.x + c * offset.y).margin(0.5));
    }
}

TEST_CASE("text moves in quarters of a pixel along its baseline, in whole pixels across") {
    Canvas canvas;
    const TextStyle style{15, black, Anchor::left, Vertical::baseline, 0};
    const Image image = written(canvas, "T", style, {100, 100});
    const auto difference = [&](double x, double y) {
        return picture::largest_difference(image, written(canvas, "T", style, {x, y}));
    };
    CHECK(difference(100.1, 100.3) == 0);
    CHECK(difference(100.25, 100) > 0);  // fails if x is snapped to pixels
    CHECK(difference(100, 101) > 0);
    const auto centre = [&](double x) { return picture::ink(written(canvas, "Tick", style, {x, 100})).x; };
    CHECK(centre(100.5) - centre(100) == Approx(0.5).margin(0.1));  // measured: 0.47
}

TEST_CASE("markup places scripts and slants letters") {
    Canvas canvas;
    const TextStyle style{30, black, Anchor::left, Vertical::baseline, 0};
    const auto ink = [&](const std::string& text) { return picture::ink(written(canvas, text, style)); };
    CHECK(ink("^{2}").y < ink("2").y - 4);
    CHECK(ink("_{2}").y > ink("2").y + 4);
    CHECK(ink("_{2}").sum < 0.7 * ink("2").sum);
    // Both on one base, one above the other: as wide as the wider one.
    CHECK(canvas.measure("x_{i}^{2}", 30).width == Approx(canvas.measure("x^{2}", 30).width).margin(0.5));
    CHECK(ink("$l$").sum == Approx(ink("l").sum).epsilon(0.05));
    CHECK(ink("$l$").right > ink("l").right + 3);
    CHECK(ink("$2$").sum == ink("2").sum);
    CHECK(ink("x$").right > ink("x").right + 5);  // a dollar alone is a dollar
}

TEST_CASE("odd texts do no harm") {
    Canvas canvas;
    for (const std::string text : {"\xff\xfe\x80", "a\xc3", "\xed\xa0\x80", "_{", "^{}", "_{}^{}", "$$$", "$",
                                   "}{", "\n\t", "^{^{^{^{^{x}}}}}"}) {
        CAPTURE(text);
        CHECK_NOTHROW(written(canvas, text, {}));
        CHECK(canvas.measure(text, 20).width >= 0);
    }
    CHECK(picture::ink(written(canvas, "\xff", {})).sum > 5);  // a sign for it is drawn
    CHECK(picture::ink(written(canvas, "x", {}, {NAN, 5})).sum == 0);
    CHECK(picture::ink(written(canvas, "x", {}, {1e300, 5})).sum == 0);
    CHECK_THROWS_AS(canvas.measure("x", 0), std::invalid_argument);
    CHECK_THROWS_AS(canvas.measure("x", NAN), std::invalid_argument);
    CHECK_THROWS_AS(canvas.measure("x", 1e9), std::invalid_argument);
}

TEST_CASE("more glyphs than there is room for are drawn nevertheless") {
    Canvas canvas;
    const auto reference =
        picture::ink(written(canvas, "M", {61, black, Anchor::left, Vertical::baseline, 0}));
    canvas.begin(4000, 2000);
    double expected = 0;
    for (int i = 0; i < 26; ++i) {
        const std::string letter(1, static_cast<char>('A' + i));
        expected +=
            picture::ink(written(canvas, letter, {300, black, Anchor::centre, Vertical::middle, 0})).sum;
    }
    const Image image = drawn(canvas, 4000, 2000, [](Canvas& c) {
        for (int i = 0; i < 26; ++i) {
            const int row = i / 13;
            c.text({150.0 + 300 * (i % 13), 300.0 + 700 * row}, std::string(1, static_cast<char>('A' + i)),
                   {300, black, Anchor::centre, Vertical::middle, 0});
        }
    });
    CHECK(picture::ink(image).sum == Approx(expected).epsilon(1e-6));  // fails if full means forgotten
    const auto again = picture::ink(written(canvas, "M", {61, black, Anchor::left, Vertical::baseline, 0}));
    CHECK(again.sum == reference.sum);
    CHECK(picture::ink(drawn(canvas, 3000, 3000, [](Canvas& c) {
              c.text({100, 2500}, "M", {2000, black, Anchor::left, Vertical::baseline, 0});
          })).sum > 5e5);  // one glyph larger than the atlas was
}
