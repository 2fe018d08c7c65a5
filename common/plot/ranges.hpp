#pragma once
#include <vector>

#include "common/plot/figure.hpp"

namespace plot {

struct Range {
    double low = 0, high = 1;
    double span() const noexcept { return high - low; }
    bool contains(double value) const noexcept { return value >= low && value <= high; }
};
struct PanelRanges {
    Range x, y;
};

/// Data units along an axis -> pixels: `from` is where range.low lies, `to` where range.high does.
struct AxisMap {
    Range range;
    Scale scale = Scale::linear;
    double from = 0, to = 1;

    double operator()(double value) const;
    double pixels_per_unit() const { return (to - from) / range.span(); }  ///< of a linear axis
};

/// True if nothing was put into the panel: such a panel is left white.
bool is_blank(const Panel& panel);

/// The ranges of every panel's axes: the explicit one; else the data with a margin of 4.5 % (log axes: of the
/// decades; none where a field ends), of all panels of the column (row) if the figure shares x (y). A panel
/// with one explicit range takes into account only the data inside it for the other. Ranges without extent (a
/// single point) are widened. Requires data without faults.
std::vector<PanelRanges> axis_ranges(const Figure& figure);

/// The range of the colour bar: the explicit one, else that of the values, widened if constant.
Range bar_range(const ColourBar& bar, const Values& values);

/// Smallest relative extent that a range may have: below it ticks lie within rounding errors.
inline constexpr double narrowest_range = 1e-11;

}  // namespace plot
