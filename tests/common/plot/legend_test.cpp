#include "common/plot/legend.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "common/plot/layout.hpp"
#include "plain_measure.hpp"

using namespace plot;

namespace {

/// A panel over the unit square whose curves leave free the quadrant with that corner only.
Panel all_but(int free_x, int free_y) {
    Panel panel;
    panel.x_range(0, 1).y_range(0, 1);
    for (int cx = 0; cx < 2; ++cx)
        for (int cy = 0; cy < 2; ++cy) {
            if (cx == free_x && cy == free_y) continue;
            Values x, y;
            for (int k = 0; k <= 200; ++k) {  // a zigzag over the quadrant
                x.push_back(0.5 * cx + 0.5 * (k % 2));
                y.push_back(0.5 * cy + 0.5 * k / 200);
            }
            panel.curve(x, y);
        }
    panel.curves[0].style.label = "zigzag";
    return panel;
}

Layout laid_out(const Panel& panel) {
    Figure figure{"legend"};
    figure.panel() = panel;
    return lay_out(figure, plain_measure);
}

}  // namespace

TEST_CASE("a legend stands in the only free corner") {
    // Fails if positions are tried without looking at the data, or if y is not turned upside down in pixels.
    const int x = GENERATE(0, 1), y = GENERATE(0, 1);
    const Panel panel = all_but(x, y);
    const auto layout = laid_out(panel).panels[0];
    REQUIRE(layout.legend.items.size() == 1);
    const Rect& box = layout.legend.box;
    const double u = ((box.left + box.right) / 2 - layout.frame.left) / layout.frame.width();
    const double v = (layout.frame.bottom - (box.top + box.bottom) / 2) / layout.frame.height();
    CHECK((u > 0.5) == (x == 1));
    CHECK((v > 0.5) == (y == 1));
    Occupancy data{layout.frame};
    data.add(panel, layout.x, layout.y);
    CHECK(data.covered(box) == 0);
}

TEST_CASE("a legend finds a gap away from the usual places") {
    // The only free place lies off the corners and middles. Fails without the finer search.
    Panel panel;
    panel.x_range(0, 1).y_range(0, 1);
    for (int k = 0; k <= 100; ++k) {
        const double y = k / 100.0;
        const bool gap = y > 0.55 && y < 0.85;
        panel.curve({0, gap ? 0.05 : 1}, {y, y}, {.colour = Colour{}});
        if (gap) panel.curve({0.5, 1}, {y, y}, {.colour = Colour{}});
    }
    panel.curves[0].style.label = "lines";
    const auto layout = laid_out(panel).panels[0];
    Occupancy data{layout.frame};
    data.add(panel, layout.x, layout.y);
    CHECK(data.covered(layout.legend.box) == 0);
}

TEST_CASE("a legend with no free place goes outside, and only then") {
    Panel panel;
    panel.x_range(0, 1).y_range(0, 1);
    for (int k = 0; k <= 200; ++k) panel.curve({0, 1}, {k / 200.0, k / 200.0}, {.colour = Colour{}});
    panel.curves[0].style.label = "everywhere";
    // Fails if the threshold tolerable_cover is ignored.
    const auto crowded = laid_out(panel);
    CHECK(crowded.panels[0].legend.box.left > crowded.panels[0].frame.right);
    CHECK(crowded.panels[0].legend.box.right < crowded.width);

    Panel free;
    free.curve({0, 1}, {0, 1}, {.label = "diagonal"});
    const auto layout = laid_out(free).panels[0];
    CHECK(layout.legend.box.right < layout.frame.right);
}

TEST_CASE("a legend shows labelled items only, in columns, with its title above") {
    Panel panel;
    panel.legend.title = "title";
    for (int k = 0; k < 5; ++k) panel.curve({0, 1}, {0, 1}, {.label = k == 2 ? "" : "curve"});
    panel.band({0, 1}, {0, 0}, {1, 1}, "band");
    const auto legend = legend_at_origin(panel, 18, 2, plain_measure);
    REQUIRE(legend.items.size() == 5);
    CHECK(legend.items.back().is_band);
    // Three rows, two columns. Fails if items are filled row by row.
    CHECK(legend.items[0].sample.left == legend.items[2].sample.left);
    CHECK(legend.items[3].sample.left > legend.items[0].text.box.right);
    CHECK(legend.items[3].sample.top == legend.items[0].sample.top);
    REQUIRE(legend.title.size() == 1);
    CHECK(legend.title[0].box.bottom <= legend.items[0].sample.top);
    for (const auto& item : legend.items) {
        CHECK(item.text.box.right < legend.box.right);
        CHECK(item.text.box.bottom < legend.box.bottom);
    }
    panel.legend.shown = false;
    CHECK(legend_at_origin(panel, 18, 2, plain_measure).items.empty());
}

TEST_CASE("notes and labels of slopes avoid the legend and each other") {
    Panel panel;
    panel.log_log();
    panel.curve({1, 10, 100}, {1, 0.1, 0.01}, {.label = "data"});
    panel.slope(-1, 1, 100, 0.3, "order 1");
    panel.note(0.75, 0.9, "a note where the legend would stand").relative = true;
    const auto layout = laid_out(panel).panels[0];
    REQUIRE(layout.slopes[0].label);
    // Fails if notes or slope labels are not entered into the occupancy before the legend is placed.
    CHECK_FALSE(overlap(layout.legend.box, layout.notes[0].box));
    CHECK_FALSE(overlap(layout.legend.box, layout.slopes[0].label->box));
    Occupancy data{layout.frame};
    data.add(panel, layout.x, layout.y);
    CHECK(data.covered(layout.slopes[0].label->box) <
          0.2);  // its box is that of rotated text: corners are empty
}

TEST_CASE("labels of coinciding slopes stand apart") {
    Panel panel;
    panel.log_log();
    panel.curve({1, 100}, {1e-3, 1e3});
    for (int k = 0; k < 2; ++k) panel.slope(0, 1, 100, 1, "order 0");
    const auto slopes = laid_out(panel).panels[0].slopes;
    // Fails if labels are not entered into the occupancy.
    CHECK_FALSE(overlap(slopes[0].label->box, slopes[1].label->box));
}
