#pragma once
#include <vector>

#include "common/plot/annotations.hpp"
#include "common/plot/legend.hpp"
#include "common/plot/ticks.hpp"

namespace plot {

/// A colour bar: `map` takes values to vertical pixels; `levels` are marked by lines (contours).
struct BarLayout {
    ColourBar bar;
    Rect box;
    AxisMap map;
    Ticks ticks;
    Values levels;
};

struct PanelLayout {
    bool blank = false;  ///< nothing is drawn
    Rect frame;          ///< between the axes
    AxisMap x, y;
    Ticks x_ticks, y_ticks;
    std::vector<BarLayout> bars;
    std::vector<TextBox> texts;  ///< around the frame: labels of ticks, axes and bars, titles, the letter
    LegendLayout legend;         ///< without items: none
    std::vector<NoteLayout> notes;
    std::vector<SlopeLayout> slopes;
};

/// Where everything in a figure stands, in pixels.
struct Layout {
    int width = 0, height = 0;
    std::vector<TextBox> texts;  ///< the figure's title
    std::vector<PanelLayout> panels;
};

/// The frames of a column have one left edge, those of a row one height; margins are as wide as the labels in
/// them. Requires a figure without faults. Depends on the figure and on `measure` only.
Layout lay_out(const Figure& figure, const Measure& measure);

/// "(a)", "(b)", ..., "(z)", "(aa)", ...
std::string panel_letter(std::size_t index);

}  // namespace plot
