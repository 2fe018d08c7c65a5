#include "common/plot/annotations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/plot/sizes.hpp"

namespace plot {
namespace {

constexpr double note_padding = 4;

double inside(double low, double length, double from, double to) {
    return std::clamp(low, from, std::max(from, to - length));
}

/// Where the line from the middle of the box to the target leaves the box.
std::optional<LineSegment> arrow_to(Point target, const Rect& box) {
    if (contains(box, target)) return std::nullopt;
    const Point middle{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
    const double dx = target.x - middle.x, dy = target.y - middle.y;
    const double t = std::min(dx == 0 ? 1.0 : box.width() / 2 / std::abs(dx),
                              dy == 0 ? 1.0 : box.height() / 2 / std::abs(dy));
    return LineSegment{{middle.x + t * dx, middle.y + t * dy}, target};
}

/// Mean cover of a row of spots along the text's middle line.
double cover_along(const TextBox& text, double length, const Occupancy& occupancy) {
    const double angle = text.style.angle * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle), up = 0.36 * text.style.size;
    double sum = 0;
    constexpr int spots = 9;
    for (int k = 0; k < spots; ++k) {
        const double along = length * (static_cast<double>(k) / (spots - 1) - 0.5);
        const Point at{text.anchor.x + c * along - s * up, text.anchor.y - s * along - c * up};
        sum += occupancy.covered(grown(Rect{at.x, at.y, at.x, at.y}, 0.5 * text.style.size));
    }
    return sum / spots;
}

}  // namespace

NoteLayout note_layout(const Note& note, const Rect& frame, const AxisMap& x_map, const AxisMap& y_map,
                       const Measure& measure) {
    const TextStyle style{.size = note.size * pixels_per_point, .colour = ink, .horizontal = note.anchor};
    const Point at = note.relative
                         ? Point{frame.left + note.x * frame.width(), frame.bottom - note.y * frame.height()}
                         : pixel(note.x, note.y, x_map, y_map);
    const auto texts = wrapped(note.text, style.size, frame.width() - 4 * note_padding, measure);
    const double pitch = line_height * style.size;
    const double height = pitch * static_cast<double>(texts.size()) + 2 * note_padding;
    double width = 0;
    for (const auto& text : texts) width = std::max(width, measure(text, style.size).width);
    width += 2 * note_padding;
    const double shift = note.anchor == Anchor::left     ? 0.0
                         : note.anchor == Anchor::centre ? width / 2
                                                         : width;
    const double left = inside(at.x - shift, width, frame.left + 2, frame.right - 2);
    const double top = inside(at.y - height / 2, height, frame.top + 2, frame.bottom - 2);
    NoteLayout result;
    result.box = {left, top, left + width, top + height};
    const double anchor_x = note.anchor == Anchor::left     ? left + note_padding
                            : note.anchor == Anchor::centre ? left + width / 2
                                                            : left + width - note_padding;
    double baseline = top + note_padding + (line_height + cap_height) / 2 * style.size;
    for (const auto& text : texts) {
        result.lines.push_back(text_box({anchor_x, baseline}, text, style, measure));
        baseline += pitch;
    }
    if (note.points_at)
        result.arrow = arrow_to(pixel((*note.points_at)[0], (*note.points_at)[1], x_map, y_map), result.box);
    return result;
}

LineSegment slope_line(const ReferenceSlope& slope, const AxisMap& x_map, const AxisMap& y_map) {
    const double y1 = slope.y0 * std::pow(slope.x1 / slope.x0, slope.order);
    return {pixel(slope.x0, slope.y0, x_map, y_map), pixel(slope.x1, y1, x_map, y_map)};
}

SlopeLayout slope_layout(const ReferenceSlope& slope, const AxisMap& x_map, const AxisMap& y_map,
                         const Occupancy& occupancy, const Measure& measure) {
    const LineSegment full = slope_line(slope, x_map, y_map);
    const auto visible = clipped(full, occupancy.area());
    SlopeLayout result{visible.value_or(full), std::nullopt};
    if (!visible || slope.label.empty()) return result;
    auto [from, to] = *visible;
    if (to.x < from.x) std::swap(from, to);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double angle = std::atan2(from.y - to.y, to.x - from.x);
    const TextStyle style{.size = 8.5 * pixels_per_point,
                          .colour = {0.3, 0.3, 0.3, 1},
                          .horizontal = Anchor::centre,
                          .angle = angle * 180 / std::numbers::pi};
    const double width = measure(slope.label, style.size).width;
    double best = 1e9;
    for (const double t : {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9})
        for (const double side : {1.0, -1.0}) {
            // Distance from the line to the baseline: a small gap above it, the text's height below it.
            const double off = side > 0 ? 0.4 * style.size : -1.1 * style.size;
            const Point anchor{from.x + t * (to.x - from.x) - std::sin(angle) * off,
                               from.y + t * (to.y - from.y) - std::cos(angle) * off};
            const TextBox text = text_box(anchor, slope.label, style, measure);
            const bool overhangs = std::min(t, 1 - t) * length < width / 2;
            const Rect& area = occupancy.area();
            const bool cut = text.box.left < area.left || text.box.right > area.right ||
                             text.box.top < area.top || text.box.bottom > area.bottom;
            const double cost =
                cover_along(text, width, occupancy) + (cut ? 10.0 : 0.0) + (overhangs ? 0.02 : 0.0);
            if (cost < best - 1e-9) {
                best = cost;
                result.label = text;
            }
        }
    return result;
}

}  // namespace plot
