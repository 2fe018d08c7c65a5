#pragma once
#include <vector>

#include "common/plot/canvas.hpp"

namespace plot {

/// The lines on which the field has the value `level`, in data units: each grid cell is cut into four
/// triangles around its centre (the mean of its corners), in which the field is linear. Closed lines end
/// where they begin; open ones end at the edge of the grid. A value equal to the level counts as above it.
std::vector<Polyline> contour_lines(const Field& field, double level);

}  // namespace plot
