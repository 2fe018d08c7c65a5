#include <algorithm>

#include "common/plot/panel_layout.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

/// The colour bars that the panel shows, their ranges resolved; the same bar of two items only once.
std::vector<BarLayout> shown_bars(const Panel& panel) {
    std::vector<BarLayout> bars;
    const auto add = [&bars](const ColourBar& bar, const Values& values, const Values& levels) {
        if (!bar.shown) return;
        const Range range = bar_range(bar, values);
        BarLayout added{bar, {}, {range, bar.scale, 0, 1}, {}, levels};
        added.bar.range = {range.low, range.high};
        const auto same = std::find_if(bars.begin(), bars.end(), [&](const BarLayout& other) {
            return other.bar.label == bar.label && other.bar.map == bar.map && other.bar.scale == bar.scale &&
                   other.bar.range == added.bar.range;
        });
        if (same == bars.end())
            bars.push_back(std::move(added));
        else
            same->levels.insert(same->levels.end(), levels.begin(), levels.end());
    };
    for (const auto& field : panel.fields) add(field.bar, field.value, field.contours);
    for (const auto& discs : panel.discs) add(discs.bar, discs.value, {});
    return bars;
}

/// Tick labels and the label right of the bar; returns where they end.
double label_bar(PanelLayout& layout, const BarLayout& bar, const Measure& measure) {
    const double left = bar.box.right + tick_length + tick_gap;
    double right = left;
    const auto add = [&](const TextBox& text) {
        right = std::max(right, text.box.right);
        layout.texts.push_back(text);
    };
    const TextStyle ticks_style{.size = tick_text, .colour = ink};
    for (const auto& tick : bar.ticks.major)
        if (!tick.label.empty())
            add(text_box({left, bar.map(tick.value) + cap_height / 2 * tick_text}, tick.label, ticks_style,
                         measure));
    const double labels_right = right;
    if (!bar.ticks.factor.empty())
        add(text_box({bar.box.left, bar.box.top - 0.75 * tick_text}, bar.ticks.factor, ticks_style, measure));
    const auto lines = wrapped(bar.bar.label, label_text, bar.box.height(), measure);
    const TextStyle label{.size = label_text, .colour = ink, .horizontal = Anchor::centre, .angle = 90};
    double baseline = labels_right + label_gap;
    for (const auto& line : lines) {
        baseline += std::max(measure(line, label_text).ascent, cap_height * label_text);
        add(text_box({baseline, (bar.box.top + bar.box.bottom) / 2}, line, label, measure));
        baseline += (line_height - cap_height) * label_text;
    }
    return right;
}

}  // namespace

double add_bars(PanelLayout& layout, const Panel& panel, double left, const Measure& measure) {
    double right = left;
    for (auto& bar : shown_bars(panel)) {
        bar.box = {right + bar_gap, layout.frame.top, right + bar_gap + bar_width, layout.frame.bottom};
        bar.map.from = layout.frame.bottom;
        bar.map.to = layout.frame.top;
        Axis axis;
        axis.scale = bar.bar.scale;
        bar.ticks = fitting_ticks(axis, bar.map, Direction::vertical, tick_text, measure);
        right = label_bar(layout, bar, measure);
        layout.bars.push_back(std::move(bar));
    }
    return right;
}

}  // namespace plot
