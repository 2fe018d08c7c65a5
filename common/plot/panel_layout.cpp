#include "common/plot/panel_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "common/plot/sizes.hpp"

namespace plot {
namespace {

constexpr TextStyle ticks_style{.size = tick_text, .colour = ink};

TextStyle centred(double size) {
    return {.size = size, .colour = ink, .horizontal = Anchor::centre};
}

class Composer {
  public:
    Composer(const PanelPlan& plan, const Rect& frame, const Measure& measure)
        : plan_{plan}, panel_{*plan.panel}, measure_{measure} {
        auto& layout = result_.layout;
        layout.frame = frame;
        layout.x = {plan.ranges.x, panel_.x.scale, frame.left, frame.right};
        layout.y = {plan.ranges.y, panel_.y.scale, frame.bottom, frame.top};
        layout.x_ticks = fitting_ticks(panel_.x, layout.x, Direction::horizontal, tick_text, measure);
        layout.y_ticks = fitting_ticks(panel_.y, layout.y, Direction::vertical, tick_text, measure);
        if (panel_.equal_aspect) equalise(layout.x_ticks, layout.y_ticks);
        core_ = frame;
    }

    ComposedPanel compose(double cell_left, double cell_right) {
        x_axis();
        y_axis();
        const double right = core_.right;
        beside();
        title(cell_left, cell_right);
        const Rect& frame = result_.layout.frame;
        result_.margins = {frame.left - core_.left, frame.top - core_.top, right - frame.right,
                           core_.bottom - frame.bottom, core_.right - right};
        return std::move(result_);
    }

  private:
    /// Where a unit is equally long on both axes, so are the steps of their ticks: the wider of the two.
    void equalise(Ticks& x, Ticks& y) const {
        if (!panel_.x.ticks.empty() || !panel_.y.ticks.empty()) return;
        const auto step = [](const Ticks& t) {
            return t.major.size() < 2 ? 0.0 : t.major[1].value - t.major[0].value;
        };
        const double wider = std::max(step(x), step(y));
        const auto widen = [&](Ticks& ticks, const Range& range) {
            for (int most = 9; most >= 1 && step(ticks) < 0.99 * wider; --most)
                if (Ticks wide = linear_ticks(range, most); step(wide) > 0.99 * wider)
                    ticks = std::move(wide);
        };
        widen(x, plan_.ranges.x);
        widen(y, plan_.ranges.y);
    }

    void add(TextBox text) {
        core_ = united(core_, text.box);
        result_.layout.texts.push_back(std::move(text));
    }

    void x_axis() {
        const auto& [frame, ticks] = std::tie(result_.layout.frame, result_.layout.x_ticks);
        double depth = tick_length + tick_gap;
        const bool labelled = plan_.x_labels && panel_.x.tick_labels;
        if (labelled) {
            double ascent = cap_height * tick_text;
            for (const auto& tick : ticks.major)
                ascent = std::max(ascent, measure_(tick.label, tick_text).ascent);
            const double baseline = frame.bottom + depth + ascent;
            for (const auto& tick : ticks.major)
                if (!tick.label.empty())
                    add(text_box({result_.layout.x(tick.value), baseline}, tick.label, centred(tick_text),
                                 measure_));
            depth = core_.bottom - frame.bottom;
        }
        result_.tick_depth_x = depth;
        x_label(frame.bottom + std::max(depth, plan_.tick_depth_x) + label_gap, labelled);
    }

    /// The axis label, and the factor at the right end: on one line if both fit.
    void x_label(double top, bool labelled) {
        const Rect& frame = result_.layout.frame;
        const std::string& factor = result_.layout.x_ticks.factor;
        double baseline = top + cap_height * label_text;
        std::vector<std::string> lines;
        if (plan_.x_labels) lines = wrapped(panel_.x.label, label_text, frame.width(), measure_);
        if (labelled && !factor.empty()) {
            const TextStyle style{.size = tick_text, .colour = ink, .horizontal = Anchor::right};
            add(text_box({frame.right, baseline}, factor, style, measure_));
            const double beside = frame.width() - 2 * (measure_(factor, tick_text).width + label_gap);
            if (widest(lines, label_text) > beside) baseline += line_height * label_text;
        }
        for (std::size_t k = 0; k < lines.size(); ++k)
            add(text_box({(frame.left + frame.right) / 2,
                          baseline + static_cast<double>(k) * line_height * label_text},
                         lines[k], centred(label_text), measure_));
    }

    double widest(const std::vector<std::string>& lines, double size) const {
        double width = 0;
        for (const auto& line : lines) width = std::max(width, measure_(line, size).width);
        return width;
    }

    void y_axis() {
        const auto& [frame, ticks] = std::tie(result_.layout.frame, result_.layout.y_ticks);
        double depth = tick_length + tick_gap;
        if (plan_.y_labels && panel_.y.tick_labels) {
            TextStyle style = ticks_style;
            style.horizontal = Anchor::right;
            double width = 0;
            for (const auto& tick : ticks.major) {
                if (tick.label.empty()) continue;
                add(text_box({frame.left - depth, result_.layout.y(tick.value) + cap_height / 2 * tick_text},
                             tick.label, style, measure_));
                width = std::max(width, measure_(tick.label, tick_text).width);
            }
            depth += width;
            if (!ticks.factor.empty()) {
                // Above a frame narrower than it, the factor makes room for what stands on the right.
                const bool narrow = measure_(ticks.factor, tick_text).width > frame.width();
                style.horizontal = narrow ? Anchor::right : Anchor::left;
                add(text_box({narrow ? frame.right : frame.left, frame.top - 8}, ticks.factor, style,
                             measure_));
                result_.has_factor = true;
            }
        }
        result_.tick_depth_y = depth;
        depth = std::max(depth, plan_.tick_depth_y);
        if (!plan_.y_labels) return;
        const auto lines = wrapped(panel_.y.label, label_text, frame.height(), measure_);
        TextStyle style = centred(label_text);
        style.angle = 90;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const double out = static_cast<double>(lines.size() - 1 - k) * line_height * label_text;
            const double descent = measure_(lines[k], label_text).descent;
            add(text_box({frame.left - depth - label_gap - std::max(0.0, descent - 0.1 * label_text) - out,
                          (frame.top + frame.bottom) / 2},
                         lines[k], style, measure_));
            y_label_top_ = std::min(y_label_top_, result_.layout.texts.back().box.top);
        }
    }

    /// Colour bars, then a legend outside, right of the frame.
    void beside() {
        auto& layout = result_.layout;
        const std::size_t before = layout.texts.size();
        double right = add_bars(layout, panel_, layout.frame.right, measure_);
        for (std::size_t k = before; k < layout.texts.size(); ++k) core_ = united(core_, layout.texts[k].box);
        for (const auto& bar : layout.bars) {
            core_ = united(core_, bar.box);
            result_.has_factor = result_.has_factor || !bar.ticks.factor.empty();
        }
        if (!plan_.legend_outside) return;
        const int columns = std::max(1, panel_.legend.columns);
        layout.legend = legend_at_origin(panel_, legend_text, columns, measure_);
        if (layout.legend.box.height() > layout.frame.height())
            layout.legend = legend_at_origin(panel_, 0.88 * legend_text, columns, measure_);
        if (layout.legend.items.empty()) return;
        layout.legend = moved(layout.legend, {right + bar_gap, layout.frame.top});
        core_ = united(core_, layout.legend.box);
    }

    /// The letter at the left end of the cell, the title centred over the frame: beside each other if the
    /// title can be made to fit, by breaking and shrinking it, else the title above the letter.
    void title(double cell_left, double cell_right) {
        const Rect frame = result_.layout.frame;
        const double centre = (frame.left + frame.right) / 2;
        const auto room = [&](double left) { return 2 * std::min(centre - left, cell_right - centre); };
        constexpr double smallest = 0.75;  // of the usual size
        // A word may be longer than a low frame is high: what is above begins above it.
        double baseline = std::min(frame.top - plan_.title_lift, y_label_top_) - title_gap;
        double width = std::max(60.0, room(cell_left));
        if (!plan_.letter.empty()) {
            const TextStyle style{.size = title_text, .colour = ink};
            const TextBox letter = text_box({cell_left, baseline}, plan_.letter, style, measure_);
            add_above(letter);
            const double beside = room(letter.box.right + 0.6 * title_text);
            const auto lines = wrapped(panel_.title, title_text, beside, measure_);
            if (smallest * widest(lines, title_text) <= beside)
                width = beside;
            else
                baseline = letter.box.top - 0.4 * title_text;
        }
        const auto lines = wrapped(panel_.title, title_text, width, measure_);
        const double size =
            title_text * std::clamp(width / std::max(1.0, widest(lines, title_text)), 0.6, 1.0);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const double up = static_cast<double>(lines.size() - 1 - k) * line_height * size;
            add_above(text_box({centre, baseline - up}, lines[k], centred(size), measure_));
        }
    }

    /// Only the top margin must hold it.
    void add_above(TextBox text) {
        core_.top = std::min(core_.top, text.box.top);
        result_.layout.texts.push_back(std::move(text));
    }

    const PanelPlan& plan_;
    const Panel& panel_;
    const Measure& measure_;
    ComposedPanel result_;
    Rect core_;  // of everything so far that the margins must hold
    double y_label_top_ = std::numeric_limits<double>::infinity();
};

/// Each label avoids the data, the notes, the other lines and their labels; its own line it may touch.
void add_slopes(PanelLayout& layout, const Panel& panel, Occupancy& occupancy, const Measure& measure) {
    std::vector<LineSegment> lines;
    for (const auto& slope : panel.slopes) lines.push_back(slope_line(slope, layout.x, layout.y));
    for (std::size_t k = 0; k < lines.size(); ++k) {
        Occupancy others = occupancy;
        for (std::size_t other = 0; other < lines.size(); ++other)
            if (other != k) others.add(lines[other]);
        const auto& added =
            layout.slopes.emplace_back(slope_layout(panel.slopes[k], layout.x, layout.y, others, measure));
        if (added.label) occupancy.add(added.label->box);
    }
    for (const auto& line : lines) occupancy.add(line);
}

}  // namespace

ComposedPanel compose(const PanelPlan& plan, const Rect& frame, double cell_left, double cell_right,
                      const Measure& measure) {
    return Composer{plan, frame, measure}.compose(cell_left, cell_right);
}

double add_inside(PanelLayout& layout, const PanelPlan& plan, const Measure& measure) {
    const Panel& panel = *plan.panel;
    Occupancy occupancy{layout.frame};
    const bool has_legend = !legend_at_origin(panel, legend_text, 1, measure).items.empty();
    if (has_legend || !panel.slopes.empty()) occupancy.add(panel, layout.x, layout.y);
    for (const auto& note : panel.notes) {
        const auto& added =
            layout.notes.emplace_back(note_layout(note, layout.frame, layout.x, layout.y, measure));
        occupancy.add(added.box);
        if (added.arrow) occupancy.add(*added.arrow);
    }
    add_slopes(layout, panel, occupancy, measure);
    if (plan.legend_outside || !has_legend) return 0;
    LegendPlace place = place_legend(panel, occupancy, measure);
    layout.legend = std::move(place.legend);
    return place.covered;
}

}  // namespace plot
