#pragma once
#include <optional>
#include <vector>

#include "common/plot/canvas.hpp"
#include "common/plot/ranges.hpp"

namespace plot {

/// Where a data point lies, in pixels; far outside points are brought to a finite distance.
Point pixel(double x, double y, const AxisMap& x_map, const AxisMap& y_map);
Polyline pixels(const Values& x, const Values& y, const AxisMap& x_map, const AxisMap& y_map);

struct LineSegment {
    Point from, to;
};
/// The part of the segment inside the rectangle (Liang and Barsky 1984); none if it misses it.
std::optional<LineSegment> clipped(const LineSegment& segment, const Rect& rect);

/// The line without points that cannot be seen: of consecutive points in the same half pixel of x, the first,
/// the last and the extreme ones in y are kept. A million points of noise cost no more than their outline.
Polyline thinned(const Polyline& line);

/// The pieces of the line inside the rectangle. Points closer than a fifth of a pixel to the one before are
/// left out.
std::vector<Polyline> clipped(const Polyline& line, const Rect& rect);

bool contains(const Rect& rect, Point point);

}  // namespace plot
