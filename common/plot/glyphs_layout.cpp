#include "common/plot/glyphs_layout.hpp"

#include <algorithm>

#include "common/plot/markup.hpp"

namespace plot {
namespace {

// In ems of the text that the script hangs on, as looks well with DejaVu Sans.
constexpr double script_size = 0.7;
constexpr double rise = 0.38, drop = 0.18;
constexpr double spread = 0.06;      // each farther out where a sub- and a superscript are stacked
constexpr double gap = 0.04;         // before a script, and behind it
constexpr double italic_gap = 0.06;  // more before a superscript of slanted text
constexpr double capital = 0.73;     // height of capitals and digits

class LineLayout {
  public:
    LineLayout(const Font& font, TextLine& line) : font_{font}, line_{line} {}

    /// Sets runs from x on the baseline y; returns where the pen stands then.
    double set(const std::vector<TextRun>& runs, double x, double y, double size) {
        for (const TextRun& run : runs) {
            x = letters(run, x, y, size);
            if (run.below.empty() && run.above.empty()) continue;
            const double start = x + gap * size;
            const double lean = run.italic ? italic_gap * size : 0;
            const double farther = run.below.empty() || run.above.empty() ? 0 : spread;
            const double low = set(run.below, start, y - (drop + farther) * size, script_size * size);
            const double high = run.above.empty() ? x
                                                  : set(run.above, start + lean, y + (rise + farther) * size,
                                                        script_size * size);
            x = std::max(low, high) + gap * size;
        }
        return x;
    }

  private:
    double letters(const TextRun& run, double x, double y, double size) {
        unsigned last = 0;
        for (const char32_t code : run.text) {
            const unsigned glyph = font_.glyph(code);
            if (last != 0) x += font_.kerning(last, glyph, size);
            line_.glyphs.push_back({glyph, size, run.italic, x, y});
            const GlyphBox box = font_.box(glyph, size, run.italic);
            line_.extent.width = std::max(line_.extent.width, x + box.right);
            line_.extent.ascent = std::max(line_.extent.ascent, y + box.top);
            line_.extent.descent = std::max(line_.extent.descent, -(y + box.bottom));
            x += font_.advance(glyph, size);
            last = glyph;
        }
        return x;
    }

    const Font& font_;
    TextLine& line_;
};

}  // namespace

TextLine lay_out(const Font& font, std::string_view text, double size) {
    TextLine line;
    line.extent.ascent = font.box(font.glyph(U'l'), size, false).top;
    line.extent.descent = -font.box(font.glyph(U'p'), size, false).bottom;
    const double end = LineLayout{font, line}.set(parse_markup(text), 0, 0, size);
    line.extent.width = std::max(line.extent.width, end);
    return line;
}

Point alignment(const TextSize& extent, const TextStyle& style) {
    Point offset;
    if (style.horizontal == Anchor::centre) offset.x = -0.5 * extent.width;
    if (style.horizontal == Anchor::right) offset.x = -extent.width;
    if (style.vertical == Vertical::top) offset.y = -extent.ascent;
    if (style.vertical == Vertical::middle) offset.y = -0.5 * capital * style.size;
    if (style.vertical == Vertical::bottom) offset.y = extent.descent;
    return offset;
}

}  // namespace plot
