#pragma once
#include "common/plot/ranges.hpp"

/// Sizes of what is drawn, in pixels. A figure is drawn at 2 pixels per point.
namespace plot {

inline constexpr double pixels_per_point = 2;

inline constexpr double tick_text = 9 * pixels_per_point;  // pixels per em
inline constexpr double label_text = 10 * pixels_per_point;
inline constexpr double legend_text = 9 * pixels_per_point;
inline constexpr double title_text = 11 * pixels_per_point;
inline constexpr double figure_title_text = 13 * pixels_per_point;

inline constexpr double tick_length = 7;
inline constexpr double minor_tick_length = 4;
inline constexpr double tick_gap = 6;    // from a tick mark to its label
inline constexpr double label_gap = 10;  // from tick labels to the axis label
inline constexpr double title_gap = 12;  // from the frame to the title
inline constexpr double spine_width = 2;

inline constexpr double bar_gap = 20;  // from the frame to its colour bar
inline constexpr double bar_width = 20;

inline constexpr double outer_margin = 18;  // white around everything
inline constexpr double panel_gap = 34;     // white between neighbours

inline constexpr Colour ink{0.13, 0.13, 0.13, 1};
inline constexpr Colour grid_colour{0.9, 0.9, 0.9, 1};
inline constexpr Colour slope_colour{0.42, 0.42, 0.42, 1};

/// Diameter of the discs in pixels.
inline double disc_pixels(const Discs& discs, const AxisMap& x_map) {
    if (discs.data_diameter <= 0) return discs.diameter * pixels_per_point;
    return discs.data_diameter * x_map.pixels_per_unit();
}

}  // namespace plot
