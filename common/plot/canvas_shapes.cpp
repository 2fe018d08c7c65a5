#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/plot/canvas_implementation.hpp"

namespace plot {
namespace {

/// A disc's edge is blurred: coverage falls from 1 to 0 over one pixel. This is the radius R that keeps the
/// area, since the integral of clamp(R + 1/2 - distance, 0, 1) over the plane is pi (R^2 + 1/12) for R >=
/// 1/2. Smaller discs could fall between the pixels' centres: they keep R = 1/2, and their `strength` makes
/// them fainter.
struct BlurredDisc {
    explicit BlurredDisc(double true_radius)
        : radius{std::sqrt(std::max(true_radius * true_radius - 1.0 / 12.0, 0.25))},
          strength{std::min(3 * true_radius * true_radius, 1.0)} {}
    double radius, strength;
};

bool near_picture(const Point& p, const PixelBox& clip, double reach) {
    return p.x > clip.left - reach && p.x < clip.right + reach && p.y > clip.top - reach &&
           p.y < clip.bottom + reach;  // false for NaN too
}

}  // namespace

void Canvas::discs(std::span<const Point> centres, double diameter, std::span<const Colour> colours) {
    if (centres.size() != colours.size()) throw std::invalid_argument{"each disc needs a colour"};
    Implementation& self = *self_;
    self.prepare();
    if (!(diameter > 0) || !std::isfinite(diameter)) return;
    std::vector<ColouredPoint> points;
    points.reserve(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
        if (near_picture(centres[i], self.clip, 0.5 * diameter + 1))
            points.push_back(
                {static_cast<float>(centres[i].x), static_cast<float>(centres[i].y), bytes(colours[i])});
    if (points.empty() || self.clip.empty()) return;
    self.draw_into_picture(self.programs.discs, self.clip);
    const BlurredDisc disc{0.5 * diameter};
    self.programs.discs.set("radius", static_cast<float>(disc.radius));
    self.programs.discs.set("strength", static_cast<float>(disc.strength));
    self.coloured_quads.draw_quads(points.data(), points.size());
}

void Canvas::markers(std::span<const Point> centres, const MarkerStyle& style) {
    Implementation& self = *self_;
    self.prepare();
    if (style.shape == Marker::none || !(style.size > 0) || !std::isfinite(style.size)) return;
    const bool arms = style.shape == Marker::plus || style.shape == Marker::cross;
    const double edge_width = std::max(style.edge_width, arms ? 1.0 : 0.0);
    // The tip of a triangle is the farthest: 0.78 sizes from the centre, and its mitred edge sticks out twice
    // half an edge width.
    const double reach = 0.8 * style.size + edge_width + 1;
    std::vector<std::array<float, 2>> points;
    points.reserve(centres.size());
    for (const Point& centre : centres)
        if (near_picture(centre, self.clip, reach))
            points.push_back({static_cast<float>(centre.x), static_cast<float>(centre.y)});
    if (points.empty() || self.clip.empty()) return;
    const Program& program = self.programs.markers;
    self.draw_into_picture(program, self.clip);
    program.set("shape", static_cast<int>(style.shape));
    program.set("size", static_cast<float>(style.size));
    program.set("edge_width", static_cast<float>(edge_width));
    program.set("reach", static_cast<float>(reach));
    program.set_colour("fill", style.filled ? bytes(style.fill) : Bytes4{});
    program.set_colour("edge", bytes(style.edge));
    self.plain_quads.draw_quads(points.data(), points.size());
}

}  // namespace plot
