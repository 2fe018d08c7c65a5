#include "common/plot/layout.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "common/plot/sizes.hpp"
#include "plain_measure.hpp"

using namespace plot;

namespace {

/// Every text that stands outside of the frames.
std::vector<TextBox> outer_texts(const Layout& layout) {
    std::vector<TextBox> texts = layout.texts;
    for (const auto& panel : layout.panels) texts.insert(texts.end(), panel.texts.begin(), panel.texts.end());
    return texts;
}

/// No two texts overlap, none is cut by the picture, none lies over a frame or a colour bar.
void check_layout(const Layout& layout) {
    const auto texts = outer_texts(layout);
    const Rect picture{0, 0, static_cast<double>(layout.width), static_cast<double>(layout.height)};
    for (std::size_t a = 0; a < texts.size(); ++a) {
        CAPTURE(texts[a].text);
        CHECK(united(picture, texts[a].box).width() == picture.width());
        CHECK(united(picture, texts[a].box).height() == picture.height());
        for (std::size_t b = a + 1; b < texts.size(); ++b) {
            CAPTURE(texts[b].text);
            CHECK_FALSE(overlap(texts[a].box, texts[b].box));
        }
        for (const auto& panel : layout.panels) {
            if (panel.blank) continue;
            CHECK_FALSE(overlap(texts[a].box, panel.frame));
            for (const auto& bar : panel.bars) CHECK_FALSE(overlap(texts[a].box, bar.box));
        }
    }
}

const char* const long_label = "a label with many words, far longer than any side of a small panel is";

Discs some_discs(double largest, std::string label) {
    Discs discs{.name = "discs", .x = {0, 0.5, 1}, .y = {0, 1, 0.5}, .value = {0, largest / 2, largest}};
    discs.bar.label = std::move(label);
    return discs;
}

Figure nasty_grid() {
    Figure figure{"nasty", 3, 3};
    figure.title = "A title of the whole figure that goes on and on and on, and then on and on and on and on";
    figure.panel_width = 280;
    figure.panel_height = 220;
    for (auto& panel : figure.panels) panel.labels("x", "y").curve({0, 1}, {0, 1}, {.label = "curve"});
    figure.at(0, 0).titled(long_label).labels(long_label, long_label).curve({0, 1}, {1e6, 1e6 + 1e-3});
    figure.at(0, 1).titled("offset").curve({1e5, 1e5 + 1e-2}, {-2e-9, 3e9});
    figure.at(0, 2).particles(some_discs(1e-5, long_label));
    figure.at(1, 0).titled("log").log_log().curves.clear();
    figure.at(1, 0).curve({1e-30, 1e30}, {1e-12, 1e3});
    figure.at(1, 1).log_log().curves.clear();
    figure.at(1, 1).curve({110, 115}, {2e-5, 9e-5});
    figure.at(1, 2).equal_aspect = true;
    figure.at(1, 2).titled("two bars").particles(some_discs(1, "first"));
    figure.at(1, 2).particles(some_discs(1e7, "second"));
    figure.at(2, 0).legend.outside = true;
    figure.at(2, 1).curves.clear();
    figure.at(2, 1).points({3}, {3}, {.label = "one point"});
    figure.at(2, 2).titled(long_label).legend.outside = true;
    return figure;
}

}  // namespace

TEST_CASE("in nasty figures no text overlaps another, is cut, or lies over a frame") {
    // Fails if margins are constants, if titles and labels are not wrapped, if the row of factors has no room
    // of its own, and if the title may run into the panel's letter.
    check_layout(lay_out(nasty_grid(), plain_measure));
}

TEST_CASE("in random figures no text overlaps another, is cut, or lies over a frame") {
    // Fails like the test above, in more ways: long words, factors beside titles, bars in some panels only.
    std::mt19937 random{11};
    const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto words = [&](int most) {
        std::string text;
        for (int k = below(most + 1); k > 0; --k)
            text += std::string(1 + random() % 9, 'w') + (k > 1 ? " " : "");
        return text;
    };
    for (int round = 0; round < 120; ++round) {
        Figure figure{"random", 1 + below(3), 1 + below(3)};
        figure.panel_width = 260 + 20 * below(10);
        figure.panel_height = 220 + 20 * below(8);
        figure.share_x = below(4) == 0;
        figure.share_y = below(4) == 0;
        figure.title = words(8);
        for (auto& panel : figure.panels) {
            const std::string title = words(8), x = words(7), y = words(5);  // in this order
            panel.titled(title).labels(x, y);
            const double size = std::pow(10.0, below(24) - 12), offset = below(3) == 0 ? 1e4 * size : 0;
            panel.curve({0, size}, {offset, offset + size}, {.label = words(2)});
            panel.equal_aspect = below(5) == 0 && !figure.share_x && !figure.share_y;
            panel.legend.outside = below(5) == 0;
            if (below(4) == 0) panel.particles(some_discs(std::pow(10.0, below(16) - 8), words(6)));
        }
        CAPTURE(round);
        check_layout(lay_out(figure, plain_measure));
    }
}

TEST_CASE("shared axes have labels at the edge of the grid only") {
    Figure figure{"shared", 3, 2};
    figure.share_x = figure.share_y = true;
    for (std::size_t k = 0; k < 6; ++k)
        figure.panels[k].labels("x", "y").curve({0, 1.0 + static_cast<double>(k)}, {0, 100});
    figure.at(1, 1).particles(some_discs(1, "bar"));
    const Layout layout = lay_out(figure, plain_measure);
    check_layout(layout);
    for (std::size_t k = 0; k < 6; ++k) {
        const PanelLayout& panel = layout.panels[k];
        // Fails if ranges are shared along rows instead of columns.
        CHECK(panel.x.range.high == layout.panels[4 + k % 2].x.range.high);
        const bool left = k % 2 == 0, lowest = k >= 4;
        const std::size_t most = 1 + (lowest ? panel.x_ticks.major.size() + 1 : 0) +
                                 (left ? panel.y_ticks.major.size() + 1 : 0) +
                                 (panel.bars.empty() ? 0 : panel.bars[0].ticks.major.size() + 1);
        CHECK(panel.texts.size() == most);
    }
}

TEST_CASE("frames of a column have one left edge, those of a row one height") {
    Figure figure{"aligned", 2, 2};
    for (auto& panel : figure.panels) panel.curve({0, 1}, {0, 1});
    figure.at(0, 0).curve({0, 1}, {0, 12345});  // wide tick labels
    figure.at(1, 1).titled("two\nlines");
    const auto panels = lay_out(figure, plain_measure).panels;
    // Fails if margins belong to panels instead of columns and rows.
    CHECK(panels[0].frame.left == panels[2].frame.left);
    CHECK(panels[1].frame.left == panels[3].frame.left);
    CHECK(panels[0].frame.right == panels[2].frame.right);
    CHECK(panels[0].frame.top == panels[1].frame.top);
    CHECK(panels[2].frame.bottom == panels[3].frame.bottom);
    CHECK(panels[0].frame.width() == Approx(panels[1].frame.width()).margin(1));
    CHECK(panels[0].frame.height() == Approx(panels[2].frame.height()).margin(1));
}

TEST_CASE("equal aspect makes a unit of x as long as one of y") {
    Figure figure{"equal"};
    figure.panel().equal_aspect = true;
    figure.panel().x_range(-2, 2).y_range(0, 1).curve({0, 1}, {0, 1});
    const Layout layout = lay_out(figure, plain_measure);
    const auto& panel = layout.panels[0];
    // Fails without trim_rows().
    CHECK(layout.height < 400);
    CHECK(panel.frame.top < 40);
    // Within the rounding of both sides to pixels, 0.5/4 + 0.5. Fails if only one side is shrunk.
    CHECK(panel.frame.width() / 4 == Approx(panel.frame.height()).margin(0.65));
    // Fails if each axis chooses its own steps (here 1 and 0.25).
    const auto step = [](const Ticks& ticks) { return ticks.major.at(1).value - ticks.major.at(0).value; };
    CHECK(step(panel.x_ticks) == step(panel.y_ticks));
}

TEST_CASE("a figure of default panels has 800 x 600 pixels a panel, most of them frame") {
    Figure figure{"default", 2, 2};
    for (auto& panel : figure.panels) panel.titled("title").labels("x", "y").curve({0, 1}, {0, 1});
    const Layout layout = lay_out(figure, plain_measure);
    CHECK(layout.width == 1600);
    CHECK(layout.height == 1200);
    for (const auto& panel : layout.panels) {
        CHECK(panel.frame.width() > 0.78 * 800);
        CHECK(panel.frame.height() > 0.72 * 600);
    }
}

TEST_CASE("ranges are the data with a margin; fields fill; ranges without extent are widened") {
    Figure figure{"ranges"};
    auto& panel = figure.panel();
    panel.curve({0, 10}, {5, 5});
    const auto flat = axis_ranges(figure)[0];
    CHECK(flat.x.low == Approx(-0.45));
    CHECK(flat.x.high == Approx(10.45));
    CHECK(flat.y.low < 5);
    CHECK(flat.y.high > 5);

    panel.curves[0].error = {1, 2};
    CHECK(axis_ranges(figure)[0].y.low == Approx(3 - 0.045 * 4));

    // An explicit range restricts what the other axis follows. Fails if all data count.
    panel.curve({20, 30}, {-100, 100});
    panel.x_range(0, 10);
    CHECK(axis_ranges(figure)[0].y.high == Approx(7 + 0.045 * 4));

    Figure log{"log"};
    log.panel().log_log().curve({1, 100}, {1e-4, 1}).error = {1, 0.5};
    const auto decades = axis_ranges(log)[0];
    CHECK(std::log10(decades.x.high) == Approx(2.09));
    // An error bar that reaches zero does not; fails if y - error <= 0 enters.
    CHECK(decades.y.low > 1e-5);

    Figure filled{"field"};
    filled.panel().field({.x = {0, 1}, .y = {0, 2}, .value = {0, 1, 2, 3}});
    CHECK(axis_ranges(filled)[0].x.low == 0);
    CHECK(axis_ranges(filled)[0].y.high == 2);
}

TEST_CASE("notes stay inside the frame and texts break at spaces") {
    Figure figure{"notes"};
    auto& panel = figure.panel();
    panel.curve({0, 1}, {0, 1});
    panel.note(1, 1, "a note at the upper right corner").points_at = {{0.5, 0.5}};
    panel.note(0, 0, "lower left");
    const auto layout = lay_out(figure, plain_measure).panels[0];
    for (const auto& note : layout.notes) {
        CHECK(united(note.box, layout.frame).width() == layout.frame.width());
        CHECK(united(note.box, layout.frame).height() == layout.frame.height());
    }
    REQUIRE(layout.notes[0].arrow);
    CHECK(layout.notes[0].arrow->to.x == Approx(layout.x(0.5)));

    const auto lines = wrapped("one two_{a b} $three four$ five\nsix", 10, 70, plain_measure);
    CHECK(lines == std::vector<std::string>{"one two_{a b}", "$three four$", "five", "six"});
}

TEST_CASE("panels are lettered as in a list") {
    CHECK(panel_letter(0) == "(a)");
    CHECK(panel_letter(25) == "(z)");
    CHECK(panel_letter(26) == "(aa)");
}
