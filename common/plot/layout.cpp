#include "common/plot/layout.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/panel_layout.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

using Lengths = std::vector<double>;

/// The largest rectangle inside `room`, in its middle, on which a unit of x is as long as one of y.
Rect with_equal_units(const Rect& room, const PanelRanges& ranges) {
    const double unit = std::min(room.width() / ranges.x.span(), room.height() / ranges.y.span());
    const double half_width = unit * ranges.x.span() / 2, half_height = unit * ranges.y.span() / 2;
    const double x = (room.left + room.right) / 2, y = (room.top + room.bottom) / 2;
    return {x - half_width, y - half_height, x + half_width, y + half_height};
}

/// Grows frames and margins against each other until every margin holds what stands in it.
class Grid {
  public:
    Grid(const Figure& figure, const Measure& measure) : figure_{figure}, measure_{measure} {
        plan_panels();
        title();
    }

    Layout layout() {
        settle();
        if (move_bad_legends_outside()) settle();
        if (trim_rows()) settle();
        Layout result;
        result.width = static_cast<int>(std::lround(width()));
        result.height = static_cast<int>(std::lround(height() - sum(spare_)));
        result.texts = title_;
        for (std::size_t k = 0; k < plans_.size(); ++k) {
            result.panels.push_back(composed_[k].layout);
            result.panels.back().blank = blank(k);
            if (!blank(k)) add_inside(result.panels.back(), plans_[k], measure_);
        }
        return result;
    }

  private:
    std::size_t column(std::size_t k) const { return k % static_cast<std::size_t>(figure_.columns); }
    std::size_t row(std::size_t k) const { return k / static_cast<std::size_t>(figure_.columns); }
    double width() const { return figure_.columns * figure_.panel_width * pixels_per_point; }
    double height() const { return figure_.rows * figure_.panel_height * pixels_per_point; }
    bool blank(std::size_t k) const { return is_blank(figure_.panels[k]); }

    /// The next panel below that is not blank: it carries the shared axis.
    bool has_panel_below(std::size_t k) const {
        for (std::size_t below = k + static_cast<std::size_t>(figure_.columns); below < figure_.panels.size();
             below += static_cast<std::size_t>(figure_.columns))
            if (!blank(below)) return true;
        return false;
    }
    bool has_panel_left(std::size_t k) const {
        for (std::size_t left = row(k) * static_cast<std::size_t>(figure_.columns); left < k; ++left)
            if (!blank(left)) return true;
        return false;
    }

    void plan_panels() {
        const auto ranges = axis_ranges(figure_);
        for (std::size_t k = 0; k < figure_.panels.size(); ++k) {
            PanelPlan plan;
            plan.panel = &figure_.panels[k];
            plan.ranges = ranges[k];
            if (figure_.letters && figure_.panels.size() > 1) plan.letter = panel_letter(k);
            plan.x_labels = !(figure_.share_x && has_panel_below(k));
            plan.y_labels = !(figure_.share_y && has_panel_left(k));
            plan.legend_outside = plan.panel->legend.outside;
            plans_.push_back(plan);
        }
        composed_.resize(plans_.size());
        const auto columns = static_cast<std::size_t>(figure_.columns);
        const auto rows = static_cast<std::size_t>(figure_.rows);
        left_ = right_ = Lengths(columns, 0);
        top_ = bottom_ = spare_ = Lengths(rows, 0);
        beside_ = Lengths(plans_.size(), 0);
    }

    void title() {
        top_of_panels_ = outer_margin;
        double baseline = outer_margin + figure_title_text;
        const TextStyle style{.size = figure_title_text, .colour = ink, .horizontal = Anchor::centre};
        for (const auto& line : wrapped(figure_.title, style.size, width() - 4 * outer_margin, measure_)) {
            title_.push_back(text_box({width() / 2, baseline}, line, style, measure_));
            baseline += line_height * style.size;
            top_of_panels_ = title_.back().box.bottom + title_gap;
        }
    }

    static double sum(const Lengths& lengths) {
        double total = 0;
        for (const double length : lengths) total += length;
        return total;
    }

    /// The right margin of a column holds its bars and outside legends if every panel has some, or if one has
    /// a legend outside: that belongs to its neighbours too, which keep the same width. A panel that alone
    /// has a colour bar is narrower instead.
    double common_beside(std::size_t c) const {
        double largest = 0;
        bool all = true, legend = false;
        for (std::size_t k = c; k < plans_.size(); k += static_cast<std::size_t>(figure_.columns)) {
            largest = std::max(largest, beside_[k]);
            all = all && (beside_[k] > 0 || blank(k));
            legend = legend || plans_[k].legend_outside;
        }
        return all || legend || figure_.share_x ? largest : 0;
    }

    double frame_width() const {
        double margins = 2 * outer_margin + (figure_.columns - 1) * panel_gap + sum(left_) + sum(right_);
        for (std::size_t c = 0; c < left_.size(); ++c) margins += common_beside(c);
        return std::max(40.0, (width() - margins) / figure_.columns);
    }
    double frame_height() const {
        const double margins =
            top_of_panels_ + outer_margin + (figure_.rows - 1) * panel_gap + sum(top_) + sum(bottom_);
        return std::max(40.0, (height() - margins) / figure_.rows);
    }

    /// The room for the panel's frame.
    Rect room(std::size_t k) const {
        Rect rect{outer_margin, top_of_panels_, 0, 0};
        for (std::size_t c = 0; c < column(k); ++c)
            rect.left += left_[c] + frame_width() + right_[c] + common_beside(c) + panel_gap;
        for (std::size_t r = 0; r < row(k); ++r)
            rect.top += top_[r] + frame_height() - spare_[r] + bottom_[r] + panel_gap;
        rect.left += left_[column(k)];
        rect.top += top_[row(k)];
        rect.right = rect.left + frame_width();
        if (common_beside(column(k)) == 0) rect.right = std::max(rect.left + 40, rect.right - beside_[k]);
        rect.bottom = rect.top + frame_height() - spare_[row(k)];
        return rect;
    }

    void compose_all() {
        for (std::size_t k = 0; k < plans_.size(); ++k) {
            if (blank(k)) continue;
            const Rect available = room(k);
            const bool equal = plans_[k].panel->equal_aspect;
            const Rect frame = equal ? with_equal_units(available, plans_[k].ranges) : available;
            const double left = std::round(frame.left), top = std::round(frame.top);
            const Rect snapped{left, top, left + std::round(frame.width()), top + std::round(frame.height())};
            composed_[k] = compose(plans_[k], snapped, snapped.left - left_[column(k)],
                                   available.right + right_[column(k)], measure_);
        }
    }

    static bool grow(double& length, double to) {
        if (to <= length + 0.01) return false;
        length = to;
        return true;
    }

    /// Margins never shrink again: so this comes to rest.
    bool grow_margins() {
        bool grown = false;
        for (std::size_t k = 0; k < plans_.size(); ++k) {
            if (blank(k)) continue;
            const auto& [layout, margins, depth_x, depth_y, has_factor] = composed_[k];
            grown |= grow(left_[column(k)], margins.left);
            grown |= grow(right_[column(k)], margins.right);
            grown |= grow(top_[row(k)], margins.top);
            grown |= grow(bottom_[row(k)], margins.bottom);
            grown |= grow(beside_[k], margins.beside);
            for (std::size_t other = 0; other < plans_.size(); ++other) {
                const bool aligned = !plans_[other].panel->equal_aspect && !plans_[k].panel->equal_aspect;
                if (has_factor && row(other) == row(k))
                    grown |= grow(plans_[other].title_lift, 1.55 * tick_text);
                if (aligned && row(other) == row(k)) grown |= grow(plans_[other].tick_depth_x, depth_x);
                if (aligned && column(other) == column(k)) grown |= grow(plans_[other].tick_depth_y, depth_y);
            }
        }
        return grown;
    }

    void settle() {
        constexpr int most_rounds = 12;
        for (int round = 0; round < most_rounds; ++round) {
            compose_all();
            if (!grow_margins()) return;
        }
        compose_all();
    }

    /// Panels of equal aspect that are as wide as possible leave room above and below: the figure is made
    /// lower where all panels of a row do.
    bool trim_rows() {
        Lengths spare(spare_.size(), height());
        for (std::size_t k = 0; k < plans_.size(); ++k)
            if (!blank(k))
                spare[row(k)] =
                    std::min(spare[row(k)], room(k).height() - composed_[k].layout.frame.height());
        bool trimmed = false;
        for (std::size_t r = 0; r < spare.size(); ++r) {
            if (spare[r] <= 2 || spare[r] >= frame_height()) continue;
            spare_[r] = std::floor(spare[r]);
            trimmed = true;
        }
        return trimmed;
    }

    bool move_bad_legends_outside() {
        bool moved = false;
        for (std::size_t k = 0; k < plans_.size(); ++k) {
            if (blank(k) || plans_[k].legend_outside) continue;
            PanelLayout trial = composed_[k].layout;
            const double covered = add_inside(trial, plans_[k], measure_);
            if (covered <= tolerable_cover) continue;
            const auto legend = legend_at_origin(*plans_[k].panel, legend_text, 1, measure_);
            const bool has_room = covered >= no_place || legend.box.width() < 0.4 * trial.frame.width();
            plans_[k].legend_outside = has_room;
            moved |= has_room;
        }
        return moved;
    }

    const Figure& figure_;
    const Measure& measure_;
    std::vector<TextBox> title_;
    double top_of_panels_ = 0;
    std::vector<PanelPlan> plans_;
    std::vector<ComposedPanel> composed_;
    Lengths left_, right_, top_, bottom_, beside_;
    Lengths spare_;  // by which the frames of a row are lower than those of other rows
};

}  // namespace

Layout lay_out(const Figure& figure, const Measure& measure) {
    return Grid{figure, measure}.layout();
}

std::string panel_letter(std::size_t index) {
    std::string letters;
    for (std::size_t rest = index + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('a' + (rest - 1) % 26));
    return "(" + letters + ")";
}

}  // namespace plot
