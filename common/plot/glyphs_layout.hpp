#pragma once
#include <string_view>
#include <vector>

#include "common/plot/canvas.hpp"
#include "common/plot/glyphs_font.hpp"

namespace plot {

/// A glyph of a line of text: its origin from the line's anchor on the baseline, x to the right, y upwards.
struct PlacedGlyph {
    unsigned glyph = 0;
    double size = 0;  ///< pixels per em
    bool italic = false;
    double x = 0, y = 0;
};

struct TextLine {
    std::vector<PlacedGlyph> glyphs;
    TextSize extent;  ///< at least that of "lp", so that labels in a row have one height
};

/// Lays out a line of UTF-8 text with markup; `size` in pixels per em.
TextLine lay_out(const Font& font, std::string_view text, double size);

/// From the anchor to the beginning of the baseline, x to the right, y upwards, in the frame of the text.
Point alignment(const TextSize& extent, const TextStyle& style);

}  // namespace plot
