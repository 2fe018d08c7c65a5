#include <algorithm>
#include <cmath>
#include <utility>

#include "common/plot/colour_map.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

/// A place on a grid line: between nodes `below` and `below` + 1.
struct Place {
    std::size_t below = 0;
    double t = 0;      // 0..1 on the way to the next node
    double pixel = 0;  // where it is drawn
};

/// Places so close that colours interpolated between them look smooth, but not closer than can be seen.
std::vector<Place> places(const Values& nodes, const AxisMap& map, double low, double high) {
    constexpr double widest = 6, narrowest = 1.5;  // pixels
    std::vector<Place> result;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const double from = map(nodes[k]), to = map(nodes[k + 1]);
        if (std::max(from, to) < low || std::min(from, to) > high) continue;
        if (!result.empty() && std::abs(from - result.back().pixel) < narrowest) continue;
        const int parts = std::clamp(static_cast<int>(std::ceil(std::abs(to - from) / widest)), 1, 4096);
        for (int p = 0; p < parts; ++p) {
            const double t = static_cast<double>(p) / parts;
            result.push_back({k, t, map(nodes[k] + t * (nodes[k + 1] - nodes[k]))});
        }
    }
    const std::size_t last = nodes.size() - 2;
    if (!result.empty()) result.push_back({last, 1, map(nodes.back())});
    return result;
}

double bilinear(const Field& field, const Place& x, const Place& y) {
    const std::size_t at = y.below * field.x.size() + x.below, up = at + field.x.size();
    const double below = field.value[at] + x.t * (field.value[at + 1] - field.value[at]);
    const double above = field.value[up] + x.t * (field.value[up + 1] - field.value[up]);
    return below + y.t * (above - below);
}

}  // namespace

void draw_field(Canvas& canvas, const Field& field, const PanelLayout& layout) {
    if (!field.filled || field.x.size() < 2 || field.y.size() < 2) return;
    const Range range = bar_range(field.bar, field.value);
    const auto columns = places(field.x, layout.x, layout.frame.left, layout.frame.right);
    const auto rows = places(field.y, layout.y, layout.frame.top, layout.frame.bottom);
    if (columns.empty() || rows.empty()) return;
    std::vector<Colour> colour;
    colour.reserve(columns.size() * rows.size());
    for (const auto& y : rows)
        for (const auto& x : columns)
            colour.push_back(
                map_colour(field.bar.map,
                           map_position(bilinear(field, x, y), {range.low, range.high}, field.bar.scale)));
    std::vector<Point> corners;
    std::vector<Colour> colours;
    corners.reserve(6 * colour.size());
    colours.reserve(6 * colour.size());
    for (std::size_t r = 0; r + 1 < rows.size(); ++r)
        for (std::size_t c = 0; c + 1 < columns.size(); ++c)
            for (const auto& [up, right] :
                 {std::pair{0U, 0U}, {0U, 1U}, {1U, 1U}, {0U, 0U}, {1U, 1U}, {1U, 0U}}) {
                corners.push_back({columns[c + right].pixel, rows[r + up].pixel});
                colours.push_back(colour[(r + up) * columns.size() + c + right]);
            }
    canvas.triangles(corners, colours);
}

}  // namespace plot
