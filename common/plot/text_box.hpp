#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/plot/canvas.hpp"

namespace plot {

/// Extent of a line of text at a size in pixels per em: Canvas::measure, or a stand-in in tests.
using Measure = std::function<TextSize(std::string_view, double)>;

/// One line of text and the pixels it covers.
struct TextBox {
    Point anchor;  ///< on the baseline
    std::string text;
    TextStyle style;
    Rect box;  ///< bounding box, also of rotated text
};

/// `style.vertical` is ignored: texts are placed by their baseline, so that labels beside each other align.
TextBox text_box(Point anchor, std::string text, TextStyle style, const Measure& measure);

/// The text broken at spaces (and at every newline) into lines no wider than `width` pixels, where possible;
/// markup is never broken.
std::vector<std::string> wrapped(const std::string& text, double size, double width, const Measure& measure);

/// Height from one baseline to the next, and of the capitals, in ems.
inline constexpr double line_height = 1.3;
inline constexpr double cap_height = 0.73;

bool overlap(const Rect& a, const Rect& b, double gap = 0);
Rect united(const Rect& a, const Rect& b);
Rect grown(const Rect& rect, double by);

}  // namespace plot
