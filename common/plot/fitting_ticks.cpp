#include <algorithm>
#include <cmath>

#include "common/plot/ticks.hpp"

namespace plot {
namespace {

/// Extent of a tick's label along the axis.
Range label_extent(const Tick& tick, const AxisMap& map, Direction direction, double text_size,
                   const Measure& measure) {
    const TextSize size = measure(tick.label, text_size);
    const double half = (direction == Direction::horizontal ? size.width : size.ascent + size.descent) / 2;
    const double at = map(tick.value);
    return {at - half, at + half};
}

bool labels_fit(const Ticks& ticks, const AxisMap& map, Direction direction, double text_size,
                const Measure& measure) {
    const double gap = (direction == Direction::horizontal ? 0.7 : 0.3) * text_size;
    std::vector<Range> extents;
    for (const auto& tick : ticks.major)
        if (!tick.label.empty()) extents.push_back(label_extent(tick, map, direction, text_size, measure));
    std::sort(extents.begin(), extents.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
    for (std::size_t k = 1; k < extents.size(); ++k)
        if (extents[k].low < extents[k - 1].high + gap) return false;
    return true;
}

/// Keeps every stride-th label, the smallest stride at which they fit; the tick marks stay.
void thin_labels(Ticks& ticks, const AxisMap& map, Direction direction, double text_size,
                 const Measure& measure) {
    const auto all = ticks.major;
    for (std::size_t stride = 1; stride <= all.size(); ++stride) {
        ticks.major = all;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (k % stride != 0) ticks.major[k].label.clear();
        if (labels_fit(ticks, map, direction, text_size, measure)) return;
    }
}

}  // namespace

Ticks fitting_ticks(const Axis& axis, const AxisMap& map, Direction direction, double text_size,
                    const Measure& measure) {
    Ticks ticks;
    if (!axis.ticks.empty()) {
        ticks = given_ticks(axis, map.range);
        thin_labels(ticks, map, direction, text_size, measure);
        return ticks;
    }
    const auto choose = [&](int most) {
        return axis.scale == Scale::log ? log_ticks(map.range, most) : linear_ticks(map.range, most);
    };
    // One interval for 3.6 (vertical: 2.4) ems reads well, but more than 7 (8) only crowd the axis.
    const double interval = (direction == Direction::horizontal ? 3.6 : 2.4) * text_size;
    const double length = std::abs(map.to - map.from);
    int most = std::clamp(static_cast<int>(length / interval), 3, direction == Direction::horizontal ? 7 : 8);
    while (most < 9 && choose(most).major.size() < 3) ++most;
    for (; most >= 1; --most) {
        Ticks fewer = choose(most);
        if (fewer.major.size() < 2) break;
        ticks = std::move(fewer);
        if (labels_fit(ticks, map, direction, text_size, measure)) return ticks;
    }
    thin_labels(ticks, map, direction, text_size, measure);
    return ticks;
}

}  // namespace plot
