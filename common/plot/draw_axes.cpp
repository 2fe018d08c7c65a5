#include <algorithm>
#include <cmath>

#include "common/plot/colour_map.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

constexpr double tick_width = 1.6;

struct TickMarks {
    const Ticks& ticks;
    const AxisMap& map;
};

/// Calls `mark` with the position along the axis and the length of each tick.
template <class Mark>
void for_each_mark(const TickMarks& marks, Mark mark) {
    for (const auto& tick : marks.ticks.major) mark(marks.map(tick.value), tick_length);
    if (marks.map.scale == Scale::log)
        for (const double value : marks.ticks.minor) mark(marks.map(value), minor_tick_length);
}

void draw_bar_levels(Canvas& canvas, const BarLayout& bar) {
    for (const double level : bar.levels) {
        const double y = bar.map(level);
        if (y <= bar.box.top || y >= bar.box.bottom) continue;
        const Colour below = map_colour(bar.bar.map, map_position(level, *bar.bar.range, bar.bar.scale));
        const Colour line = luminance(below) < 0.25 ? Colour{1, 1, 1, 0.85} : Colour{0, 0, 0, 0.75};
        canvas.rule({bar.box.left, y}, {bar.box.right, y}, 2, line);
    }
}

void outline(Canvas& canvas, const Rect& box, double width, Colour colour) {
    canvas.rule({box.left, box.top}, {box.right, box.top}, width, colour);
    canvas.rule({box.left, box.bottom}, {box.right, box.bottom}, width, colour);
    canvas.rule({box.left, box.top}, {box.left, box.bottom}, width, colour);
    canvas.rule({box.right, box.top}, {box.right, box.bottom}, width, colour);
}

}  // namespace

void draw_grid(Canvas& canvas, const Panel&, const PanelLayout& layout) {
    const Rect& frame = layout.frame;
    for (const auto& tick : layout.x_ticks.major) {
        const double x = layout.x(tick.value);
        canvas.rule({x, frame.top}, {x, frame.bottom}, 2, grid_colour);
    }
    for (const auto& tick : layout.y_ticks.major) {
        const double y = layout.y(tick.value);
        canvas.rule({frame.left, y}, {frame.right, y}, 2, grid_colour);
    }
}

void draw_frame(Canvas& canvas, const PanelLayout& layout) {
    const Rect& frame = layout.frame;
    for_each_mark({layout.x_ticks, layout.x}, [&](double x, double length) {
        canvas.rule({x, frame.bottom}, {x, frame.bottom + length}, tick_width, ink);
    });
    for_each_mark({layout.y_ticks, layout.y}, [&](double y, double length) {
        canvas.rule({frame.left - length, y}, {frame.left, y}, tick_width, ink);
    });
    outline(canvas, frame, spine_width, ink);
}

void draw_bar(Canvas& canvas, const BarLayout& bar) {
    constexpr int slices = 256;
    std::vector<Point> corners;
    std::vector<Colour> colours;
    const auto& box = bar.box;
    const auto y_at = [&box](int k) { return box.bottom - box.height() * k / slices; };
    const auto colour_at = [&bar](int k) { return map_colour(bar.bar.map, static_cast<double>(k) / slices); };
    for (int k = 0; k < slices; ++k) {
        const double low = y_at(k), high = y_at(k + 1);
        corners.insert(corners.end(), {{box.left, low},
                                       {box.right, low},
                                       {box.right, high},
                                       {box.left, low},
                                       {box.right, high},
                                       {box.left, high}});
        const Colour c0 = colour_at(k), c1 = colour_at(k + 1);
        colours.insert(colours.end(), {c0, c0, c1, c0, c1, c1});
    }
    canvas.triangles(corners, colours);
    draw_bar_levels(canvas, bar);
    for_each_mark({bar.ticks, bar.map}, [&](double y, double length) {
        canvas.rule({box.right, y}, {box.right + length, y}, tick_width, ink);
    });
    outline(canvas, box, tick_width, ink);
}

}  // namespace plot
