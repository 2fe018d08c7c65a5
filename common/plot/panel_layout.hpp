#pragma once
#include "common/plot/layout.hpp"

namespace plot {

/// A panel and what the grid of panels decides about it.
struct PanelPlan {
    const Panel* panel = nullptr;
    PanelRanges ranges;
    std::string letter;                     ///< empty: none
    bool x_labels = true, y_labels = true;  ///< labels of ticks and axis; false where they are shared
    bool legend_outside = false;
    double title_lift = 0;    ///< room between frame and title for the factors of axes
    double tick_depth_x = 0;  ///< least distance from the frame to the axis label, so that neighbours align
    double tick_depth_y = 0;
};

/// Margins around a frame.
struct Margins {
    double left = 0, top = 0, right = 0, bottom = 0;
    double beside = 0;  ///< in addition to `right`: colour bars, a legend outside
};

struct ComposedPanel {
    PanelLayout layout;
    Margins margins;
    double tick_depth_x = 0, tick_depth_y = 0;  ///< from the frame to the end of the tick labels
    bool has_factor = false;                    ///< above the frame
};

/// Everything around the frame. `cell_left`, `cell_right`: as far as the title may reach; the letter stands
/// at cell_left.
ComposedPanel compose(const PanelPlan& plan, const Rect& frame, double cell_left, double cell_right,
                      const Measure& measure);

/// Adds the panel's colour bars from `left` on; returns where the last one ends.
double add_bars(PanelLayout& layout, const Panel& panel, double left, const Measure& measure);

/// Adds slopes, notes and a legend inside the frame; returns the fraction of the legend that covers data.
double add_inside(PanelLayout& layout, const PanelPlan& plan, const Measure& measure);

}  // namespace plot
