#include "common/plot/polyline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plot {

Point pixel(double x, double y, const AxisMap& x_map, const AxisMap& y_map) {
    constexpr double far = 1e7;
    return {std::clamp(x_map(x), -far, far), std::clamp(y_map(y), -far, far)};
}

Polyline pixels(const Values& x, const Values& y, const AxisMap& x_map, const AxisMap& y_map) {
    Polyline line(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) line[i] = pixel(x[i], y[i], x_map, y_map);
    return line;
}

std::optional<LineSegment> clipped(const LineSegment& segment, const Rect& rect) {
    const auto [a, b] = segment;
    const double dx = b.x - a.x, dy = b.y - a.y;
    // direction towards each edge, and distance to it
    const std::array<std::array<double, 2>, 4> edges{
        {{-dx, a.x - rect.left}, {dx, rect.right - a.x}, {-dy, a.y - rect.top}, {dy, rect.bottom - a.y}}};
    double enter = 0, leave = 1;
    for (const auto& [towards, distance] : edges) {
        if (towards == 0) {
            if (distance < 0) return std::nullopt;
        } else if (towards < 0) {
            enter = std::max(enter, distance / towards);
        } else {
            leave = std::min(leave, distance / towards);
        }
    }
    if (enter > leave) return std::nullopt;
    const auto at = [&, &from = a](double t) { return Point{from.x + t * dx, from.y + t * dy}; };
    return LineSegment{enter > 0 ? at(enter) : a, leave < 1 ? at(leave) : b};
}

Polyline thinned(const Polyline& line) {
    const auto column = [](Point at) { return std::floor(2 * at.x); };
    const auto lower = [](Point a, Point b) { return a.y < b.y; };
    Polyline result;
    for (auto begin = line.begin(); begin != line.end();) {
        const auto end =
            std::find_if(begin, line.end(), [&](Point at) { return column(at) != column(*begin); });
        if (end - begin <= 4) {
            result.insert(result.end(), begin, end);
        } else {
            const auto [low, high] = std::minmax_element(begin, end, lower);
            result.insert(result.end(), {*begin, *std::min(low, high), *std::max(low, high), *(end - 1)});
        }
        begin = end;
    }
    return result;
}

std::vector<Polyline> clipped(const Polyline& line, const Rect& rect) {
    constexpr double merged = 0.2;
    std::vector<Polyline> pieces;
    bool connected = false;
    std::size_t last = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const bool is_end = i + 1 == line.size();
        if (!is_end && std::hypot(line[i].x - line[last].x, line[i].y - line[last].y) < merged) continue;
        const auto part = clipped(LineSegment{line[last], line[i]}, rect);
        if (part) {
            if (!connected) pieces.push_back({part->from});
            pieces.back().push_back(part->to);
        }
        connected = part && contains(rect, line[i]);
        last = i;
    }
    return pieces;
}

bool contains(const Rect& rect, Point point) {
    return point.x >= rect.left && point.x <= rect.right && point.y >= rect.top && point.y <= rect.bottom;
}

}  // namespace plot
