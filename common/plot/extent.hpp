#pragma once
#include <functional>

#include "common/plot/figure.hpp"

namespace plot {

/// What one item covers around a point of its data.
struct DataPoint {
    double x = 0, y = 0;
    double half_width = 0, half_height = 0;  ///< in data units: discs of a given diameter, error bars
    bool may_reach_zero = false;             ///< the half height is an error bar: ignored on a log axis
    bool fills = false;                      ///< the corner of a field: the axis may end here
};

/// Calls `visit` with every data point of the panel: curves, bands, discs, corners of fields, both ends of
/// arrows and of reference slopes, notes and their targets (unless relative).
void for_each_point(const Panel& panel, const std::function<void(const DataPoint&)>& visit);

}  // namespace plot
