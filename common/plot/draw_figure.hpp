#pragma once
#include "common/plot/canvas.hpp"
#include "common/plot/layout.hpp"

namespace plot {

/// The picture of a figure without faults. The canvas' former picture is lost.
Image draw(Canvas& canvas, const Figure& figure);

/// Parts of draw(), in its order; all but the frame and its texts are clipped to the frame.
void draw_grid(Canvas& canvas, const Panel& panel, const PanelLayout& layout);
void draw_field(Canvas& canvas, const Field& field, const PanelLayout& layout);
void draw_contours(Canvas& canvas, const Field& field, const PanelLayout& layout);
void draw_band(Canvas& canvas, const Band& band, Colour colour, const PanelLayout& layout);
void draw_discs(Canvas& canvas, const Discs& discs, const PanelLayout& layout);
void draw_arrows(Canvas& canvas, const Arrows& arrows, const PanelLayout& layout);
void draw_slope(Canvas& canvas, const SlopeLayout& slope);
void draw_curve(Canvas& canvas, const Curve& curve, Colour colour, const PanelLayout& layout);
void draw_frame(Canvas& canvas, const PanelLayout& layout);
void draw_bar(Canvas& canvas, const BarLayout& bar);
void draw_note(Canvas& canvas, const NoteLayout& note);
void draw_legend(Canvas& canvas, const LegendLayout& legend);

/// A straight arrow with a filled head as long as 4 widths (at most 0.45 of the arrow), all of one colour.
void draw_arrow_lines(Canvas& canvas, const std::vector<LineSegment>& arrows, double width, Colour colour);

/// Lengths of drawn and left-out pieces in pixels for a line of that width; empty for solid.
std::vector<double> dash_lengths(Dash dash, double width);
/// Markers as curves draw them: filled ones with a darker edge.
MarkerStyle marker_style(const Style& style, Colour colour);

void draw_text(Canvas& canvas, const TextBox& text);

}  // namespace plot
