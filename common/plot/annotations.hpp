#pragma once
#include <optional>
#include <vector>

#include "common/plot/occupancy.hpp"
#include "common/plot/text_box.hpp"

namespace plot {

struct NoteLayout {
    Rect box;
    std::vector<TextBox> lines;
    std::optional<LineSegment> arrow;  ///< from the edge of the box to the target
};
/// The note's text centred vertically on its position, moved inside the frame if it would be cut.
NoteLayout note_layout(const Note& note, const Rect& frame, const AxisMap& x_map, const AxisMap& y_map,
                       const Measure& measure);

struct SlopeLayout {
    LineSegment line;
    std::optional<TextBox> label;  ///< along the line, on the side and at the place where it covers least
};
/// The whole line in pixels; it may leave the frame.
LineSegment slope_line(const ReferenceSlope& slope, const AxisMap& x_map, const AxisMap& y_map);
SlopeLayout slope_layout(const ReferenceSlope& slope, const AxisMap& x_map, const AxisMap& y_map,
                         const Occupancy& occupancy, const Measure& measure);

}  // namespace plot
