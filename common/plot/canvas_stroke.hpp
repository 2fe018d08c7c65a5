#pragma once
#include <span>
#include <vector>

#include "common/plot/canvas_boxes.hpp"

namespace plot {

/// A straight piece of a stroke with round caps.
struct Segment {
    float ax, ay, bx, by;
};

/// The visible pieces of polylines: cut to `visible` (plus the stroke's width), into dashes, and at points
/// that are not finite. A point alone is a piece without length. `dashes`: lengths of drawn and left-out
/// pieces in pixels, caps included, along each polyline from its beginning; empty for solid. Throws
/// std::invalid_argument if one is negative or not finite, if their number is odd, or if together they are
/// shorter than 0.1 pixels.
std::vector<Segment> stroke_segments(std::span<const Polyline> lines, double width,
                                     std::span<const double> dashes, const Rect& visible);

/// Boxes without overlap that contain every pixel of `area` nearer than `reach` to one of the pieces, and not
/// many more: a curve leaves most of the box around it empty, and empty pixels cost time too.
std::vector<PixelBox> touched_boxes(std::span<const Segment> segments, double reach, const PixelBox& area);

}  // namespace plot
