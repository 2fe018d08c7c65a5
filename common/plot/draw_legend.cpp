#include <cmath>
#include <numbers>

#include "common/plot/colour_map.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

/// The outline of a rectangle with rounded corners, closed.
Polyline rounded(const Rect& box, double radius) {
    Polyline line;
    const auto corner = [&](double x, double y, double from) {
        constexpr int steps = 6;
        for (int k = 0; k <= steps; ++k) {
            const double angle = from + std::numbers::pi / 2 * k / steps;
            line.push_back({x + radius * std::cos(angle), y - radius * std::sin(angle)});
        }
    };
    const double quarter = std::numbers::pi / 2;
    corner(box.right - radius, box.top + radius, 0);
    corner(box.left + radius, box.top + radius, quarter);
    corner(box.left + radius, box.bottom - radius, 2 * quarter);
    corner(box.right - radius, box.bottom - radius, 3 * quarter);
    line.push_back(line.front());
    return line;
}

void fill(Canvas& canvas, const Polyline& convex, Colour colour) {
    std::vector<Point> corners;
    for (std::size_t k = 2; k < convex.size(); ++k)
        corners.insert(corners.end(), {convex[0], convex[k - 1], convex[k]});
    canvas.triangles(corners, std::vector<Colour>(corners.size(), colour));
}

void draw_sample(Canvas& canvas, const LegendItem& item) {
    const Rect& sample = item.sample;
    if (item.is_band) {
        canvas.rectangle(sample, item.colour);
        return;
    }
    const double middle = (sample.top + sample.bottom) / 2;
    if (item.style.width > 0) {
        const double width = item.style.width * pixels_per_point;
        canvas.stroke(std::vector<Polyline>{{{sample.left, middle}, {sample.right, middle}}}, width,
                      item.colour, dash_lengths(item.style.dash, width));
    }
    if (item.style.marker == Marker::none) return;
    const Point centre{(sample.left + sample.right) / 2, middle};
    canvas.markers(std::vector<Point>{centre}, marker_style(item.style, item.colour));
}

}  // namespace

void draw_legend(Canvas& canvas, const LegendLayout& legend) {
    if (legend.items.empty()) return;
    const Polyline outline = rounded(legend.box, 6);
    fill(canvas, outline, {1, 1, 1, 0.85});
    canvas.stroke(std::vector<Polyline>{outline}, 1.6, {0.78, 0.78, 0.78, 1});
    for (const auto& title : legend.title) draw_text(canvas, title);
    for (const auto& item : legend.items) {
        draw_sample(canvas, item);
        draw_text(canvas, item.text);
    }
}

void draw_note(Canvas& canvas, const NoteLayout& note) {
    fill(canvas, rounded(note.box, 5), {1, 1, 1, 0.75});
    if (note.arrow) draw_arrow_lines(canvas, {*note.arrow}, 1.6, ink);
    for (const auto& line : note.lines) draw_text(canvas, line);
}

}  // namespace plot
