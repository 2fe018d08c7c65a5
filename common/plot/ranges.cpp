#include "common/plot/ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/plot/extent.hpp"

namespace plot {
namespace {

constexpr double margin = 0.045;  // of the axis, at each end
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Extent of the data along one axis so far; `fills` tells whether a field ends there.
struct Extent {
    double low = infinity, high = -infinity;
    bool low_fills = false, high_fills = false;

    bool empty() const { return low > high; }
    void add(double value, bool fills) {
        if (value < low || (value == low && fills)) low_fills = fills;
        if (value > high || (value == high && fills)) high_fills = fills;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void add(const Extent& other) {
        if (other.empty()) return;
        add(other.low, other.low_fills);
        add(other.high, other.high_fills);
    }
};

Range widened(Range range) {
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    if (range.span() > 10 * narrowest_range * largest) return range;
    const double centre = (range.low + range.high) / 2;
    const double half = centre == 0 ? 1.0 : 0.05 * std::abs(centre);
    return {centre - half, centre + half};
}

Range with_margin(const Extent& extent, Scale scale) {
    if (extent.empty()) return scale == Scale::log ? Range{1, 10} : Range{0, 1};
    if (scale == Scale::log) {
        const double decades = std::log10(extent.high / extent.low);
        const double factor = std::pow(10.0, decades > 1e-9 ? margin * decades : 0.2);
        return {extent.low_fills ? extent.low : extent.low / factor,
                extent.high_fills ? extent.high : extent.high * factor};
    }
    const Range range{extent.low, extent.high};
    const Range wide = widened(range);
    if (wide.low != range.low) return wide;
    const double added = margin * range.span();
    return {extent.low_fills ? range.low : range.low - added,
            extent.high_fills ? range.high : range.high + added};
}

bool inside(const std::optional<std::array<double, 2>>& range, double value) {
    return !range || (value >= (*range)[0] && value <= (*range)[1]);
}

void add_point(Extent& extent, double value, double half, Scale scale, const DataPoint& point) {
    extent.add(value, point.fills);
    if (half == 0) return;
    extent.add(value + half, false);
    if (scale == Scale::linear || value > half) extent.add(value - half, false);
}

struct Extents {
    Extent x, y;
};

/// Of the points inside the explicit ranges; of all points if there are none.
Extents extents(const Panel& panel) {
    Extents seen, all;
    for_each_point(panel, [&](const DataPoint& point) {
        const auto add = [&](Extents& to, bool x, bool y) {
            if (x) add_point(to.x, point.x, point.half_width, panel.x.scale, point);
            if (y) add_point(to.y, point.y, point.half_height, panel.y.scale, point);
        };
        add(all, true, true);
        add(seen, inside(panel.y.range, point.y), inside(panel.x.range, point.x));
    });
    return {seen.x.empty() ? all.x : seen.x, seen.y.empty() ? all.y : seen.y};
}

/// The range of one axis that is common to the panels of `group`.
void resolve(const Figure& figure, const std::vector<std::size_t>& group, Axis Panel::*axis,
             const std::vector<Extents>& data, Extent Extents::*extent, std::vector<PanelRanges>& ranges,
             Range PanelRanges::*result) {
    Extent common;
    std::optional<std::array<double, 2>> given;
    for (const std::size_t k : group) {
        common.add(data[k].*extent);
        if (!given) given = (figure.panels[k].*axis).range;
    }
    const Scale scale = (figure.panels[group.front()].*axis).scale;
    const Range range = given ? Range{(*given)[0], (*given)[1]} : with_margin(common, scale);
    for (const std::size_t k : group) ranges[k].*result = range;
}

/// Panel indices that share an axis: those with the same key; each alone if `shared` is false.
std::vector<std::vector<std::size_t>> groups(const Figure& figure, bool shared, bool by_column) {
    std::vector<std::vector<std::size_t>> result;
    const auto columns = static_cast<std::size_t>(figure.columns);
    const std::size_t count = !shared     ? figure.panels.size()
                              : by_column ? columns
                                          : figure.panels.size() / columns;
    result.resize(count);
    for (std::size_t k = 0; k < figure.panels.size(); ++k)
        result[!shared ? k : by_column ? k % columns : k / columns].push_back(k);
    return result;
}

}  // namespace

double AxisMap::operator()(double value) const {
    return from + (to - from) * (scale == Scale::log
                                     ? std::log(value / range.low) / std::log(range.high / range.low)
                                     : (value - range.low) / range.span());
}

bool is_blank(const Panel& panel) {
    return panel.curves.empty() && panel.bands.empty() && panel.discs.empty() && panel.fields.empty() &&
           panel.arrows.empty() && panel.notes.empty() && panel.slopes.empty() && panel.title.empty() &&
           panel.x.label.empty() && panel.y.label.empty();
}

std::vector<PanelRanges> axis_ranges(const Figure& figure) {
    std::vector<Extents> data;
    data.reserve(figure.panels.size());
    for (const auto& panel : figure.panels) data.push_back(extents(panel));
    std::vector<PanelRanges> ranges(figure.panels.size());
    for (const auto& group : groups(figure, figure.share_x, true))
        resolve(figure, group, &Panel::x, data, &Extents::x, ranges, &PanelRanges::x);
    for (const auto& group : groups(figure, figure.share_y, false))
        resolve(figure, group, &Panel::y, data, &Extents::y, ranges, &PanelRanges::y);
    return ranges;
}

Range bar_range(const ColourBar& bar, const Values& values) {
    if (bar.range) return {(*bar.range)[0], (*bar.range)[1]};
    if (values.empty()) return bar.scale == Scale::log ? Range{1, 10} : Range{0, 1};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (bar.scale == Scale::linear) return widened({*low, *high});
    return *high > *low * (1 + 1e-9) ? Range{*low, *high} : Range{*low / 1.5, *high * 1.5};
}

}  // namespace plot
