#include <algorithm>
#include <cmath>

#include "common/plot/colour_map.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

/// What lies within this distance of the frame may still be seen: half the width of strokes and markers.
constexpr double reach = 40;

void draw_error_bars(Canvas& canvas, const Curve& curve, Colour colour, const PanelLayout& layout) {
    const double cap = std::max(2.5, 0.5 * curve.style.marker_size) * pixels_per_point;
    const Rect seen = grown(layout.frame, reach);
    std::vector<Polyline> bars;
    const auto add = [&](Point from, Point to) {
        if (const auto part = clipped(LineSegment{from, to}, seen)) bars.push_back({part->from, part->to});
    };
    for (std::size_t i = 0; i < curve.error.size(); ++i) {
        if (curve.error[i] == 0) continue;
        const bool reaches_zero = layout.y.scale == Scale::log && curve.error[i] >= curve.y[i];
        const Point top = pixel(curve.x[i], curve.y[i] + curve.error[i], layout.x, layout.y);
        const Point bottom = reaches_zero
                                 ? Point{top.x, seen.bottom}
                                 : pixel(curve.x[i], curve.y[i] - curve.error[i], layout.x, layout.y);
        add(top, bottom);
        for (const Point end : {top, bottom}) add({end.x - cap, end.y}, {end.x + cap, end.y});
    }
    canvas.stroke(bars, 1.1 * pixels_per_point, colour);
}

}  // namespace

std::vector<double> dash_lengths(Dash dash, double width) {
    // Round caps lengthen every piece by one width and shorten every gap.
    switch (dash) {
        case Dash::solid:
            return {};
        case Dash::dashed:
            return {3.2 * width, 3.0 * width};
        case Dash::dotted:
            return {0.05 * width, 2.3 * width};
        case Dash::dash_dotted:
            return {4 * width, 2.6 * width, 0.05 * width, 2.6 * width};
    }
    return {};
}

MarkerStyle marker_style(const Style& style, Colour colour) {
    const bool lines_only = style.marker == Marker::plus || style.marker == Marker::cross;
    MarkerStyle marker;
    marker.shape = style.marker;
    marker.size = style.marker_size * pixels_per_point;
    marker.fill = colour;
    marker.filled = style.filled && !lines_only;
    marker.edge = marker.filled ? faded(mixed(colour, {0, 0, 0, 1}, 0.35), colour.alpha) : colour;
    marker.edge_width = (marker.filled ? 0.6 : 1.1) * pixels_per_point;
    return marker;
}

void draw_curve(Canvas& canvas, const Curve& curve, Colour colour, const PanelLayout& layout) {
    const Polyline line = pixels(curve.x, curve.y, layout.x, layout.y);
    const Style& style = curve.style;
    const Rect seen = grown(layout.frame, reach);
    if (style.width > 0) {
        const double width = style.width * pixels_per_point;
        canvas.stroke(clipped(thinned(line), seen), width, colour, dash_lengths(style.dash, width));
    }
    if (!curve.error.empty()) draw_error_bars(canvas, curve, colour, layout);
    if (style.marker == Marker::none) return;
    std::vector<Point> centres;
    std::copy_if(line.begin(), line.end(), std::back_inserter(centres),
                 [&seen](Point at) { return contains(seen, at); });
    // A marker on the frame is drawn whole: half a disc would not tell where its centre is.
    std::vector<Point> on_frame;
    std::copy_if(centres.begin(), centres.end(), std::back_inserter(on_frame),
                 [&](Point at) { return contains(grown(layout.frame, 0.5), at); });
    canvas.unclip();
    canvas.markers(on_frame, marker_style(style, colour));
    canvas.clip(layout.frame);
}

void draw_band(Canvas& canvas, const Band& band, Colour colour, const PanelLayout& layout) {
    std::vector<Point> corners;
    for (std::size_t i = 1; i < band.x.size(); ++i) {
        const auto at = [&](std::size_t k, const Values& y) {
            return pixel(band.x[k], y[k], layout.x, layout.y);
        };
        const Point low0 = at(i - 1, band.low), low1 = at(i, band.low);
        const Point high0 = at(i - 1, band.high), high1 = at(i, band.high);
        corners.insert(corners.end(), {low0, low1, high1, low0, high1, high0});
    }
    canvas.triangles(corners, std::vector<Colour>(corners.size(), colour));
}

void draw_discs(Canvas& canvas, const Discs& discs, const PanelLayout& layout) {
    const Range range = bar_range(discs.bar, discs.value);
    const double diameter = disc_pixels(discs, layout.x);
    const Rect seen = grown(layout.frame, diameter);
    std::vector<Point> centres;
    std::vector<Colour> colours;
    for (std::size_t i = 0; i < discs.x.size(); ++i) {
        const Point centre = pixel(discs.x[i], discs.y[i], layout.x, layout.y);
        if (!contains(seen, centre)) continue;
        centres.push_back(centre);
        colours.push_back(map_colour(discs.bar.map,
                                     map_position(discs.value[i], {range.low, range.high}, discs.bar.scale)));
    }
    canvas.discs(centres, diameter, colours);
}

void draw_arrows(Canvas& canvas, const Arrows& arrows, const PanelLayout& layout) {
    std::vector<LineSegment> segments;
    for (std::size_t i = 0; i < arrows.x.size(); ++i)
        segments.push_back({pixel(arrows.x[i], arrows.y[i], layout.x, layout.y),
                            pixel(arrows.x[i] + arrows.scale * arrows.u[i],
                                  arrows.y[i] + arrows.scale * arrows.v[i], layout.x, layout.y)});
    draw_arrow_lines(canvas, segments, arrows.width * pixels_per_point, arrows.colour);
}

void draw_arrow_lines(Canvas& canvas, const std::vector<LineSegment>& arrows, double width, Colour colour) {
    std::vector<Polyline> shafts;
    std::vector<Point> heads;
    for (const auto& [from, to] : arrows) {
        const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
        if (length == 0) {
            shafts.push_back({from, to});
            continue;
        }
        const double head = std::min(3 + 4 * width, 0.45 * length), half = 0.38 * head;
        const Point base{to.x - dx / length * head, to.y - dy / length * head};
        const Point side{-dy / length * half, dx / length * half};
        shafts.push_back({from, {base.x + dx / length * head / 2, base.y + dy / length * head / 2}});
        heads.insert(heads.end(),
                     {to, {base.x + side.x, base.y + side.y}, {base.x - side.x, base.y - side.y}});
    }
    canvas.stroke(shafts, width, colour);
    canvas.triangles(heads, std::vector<Colour>(heads.size(), colour));
}

void draw_slope(Canvas& canvas, const SlopeLayout& slope) {
    const double width = 1.2 * pixels_per_point;
    canvas.stroke(std::vector<Polyline>{{slope.line.from, slope.line.to}}, width, slope_colour,
                  dash_lengths(Dash::dashed, width));
    if (slope.label) draw_text(canvas, *slope.label);
}

}  // namespace plot
