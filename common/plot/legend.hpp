#pragma once
#include <vector>

#include "common/plot/occupancy.hpp"
#include "common/plot/text_box.hpp"

namespace plot {

/// One line of a legend: how the curve or band looks, and where.
struct LegendItem {
    Style style;
    Colour colour;
    bool is_band = false;
    Rect sample;  ///< where a piece of line with its marker, or a piece of the band, is drawn
    TextBox text;
};
struct LegendLayout {
    Rect box;
    std::vector<TextBox> title;  ///< no element or one
    std::vector<LegendItem> items;
};

/// Colours of the panel's curves and bands: their own, else the next of the cycle (curves first).
std::vector<Colour> curve_colours(const Panel& panel);
std::vector<Colour> band_colours(const Panel& panel);

/// The legend of all labelled curves and bands in `columns` columns, its box at (0, 0); no items if nothing
/// is labelled or the legend is switched off.
LegendLayout legend_at_origin(const Panel& panel, double text_size, int columns, const Measure& measure);
LegendLayout moved(LegendLayout legend, Point by);

struct LegendPlace {
    LegendLayout legend;
    double covered = 0;  ///< fraction of its box that lies over data
};
/// The legend inside the area where it covers the least data: of the corners and middles of the edges the
/// first free one; else the free place nearest to one; else with more columns or smaller text; else the least
/// bad.
LegendPlace place_legend(const Panel& panel, const Occupancy& occupancy, const Measure& measure);

/// What place_legend() returns with an empty legend: its box is larger than the area.
inline constexpr double no_place = 2;
/// A legend that covers more than this is better placed outside.
inline constexpr double tolerable_cover = 0.035;

}  // namespace plot
