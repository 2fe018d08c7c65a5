#include "common/plot/text_box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace plot {
namespace {

/// Words separated by spaces that lie outside of `{..}` and `$..$`.
std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> result(1);
    int depth = 0;
    bool italic = false;
    for (const char c : text) {
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        italic = italic != (c == '$');
        if (c == ' ' && depth <= 0 && !italic)
            result.emplace_back();
        else
            result.back() += c;
    }
    return result;
}

void wrap_line(std::string_view text, double size, double width, const Measure& measure,
               std::vector<std::string>& lines) {
    std::string line;
    for (const auto& word : words(text)) {
        const std::string longer = line.empty() ? word : line + " " + word;
        if (!line.empty() && measure(longer, size).width > width) {
            lines.push_back(std::exchange(line, word));
        } else {
            line = longer;
        }
    }
    lines.push_back(line);
}

}  // namespace

TextBox text_box(Point anchor, std::string text, TextStyle style, const Measure& measure) {
    style.vertical = Vertical::baseline;
    const TextSize size = measure(text, style.size);
    const double left = style.horizontal == Anchor::left     ? 0.0
                        : style.horizontal == Anchor::centre ? -size.width / 2
                                                             : -size.width;
    const double angle = style.angle * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto corner = [&](double along, double down) {
        const Point at{anchor.x + c * along + s * down, anchor.y - s * along + c * down};
        return Rect{at.x, at.y, at.x, at.y};
    };
    const double right = left + size.width;
    const Rect box = united(united(corner(left, -size.ascent), corner(right, -size.ascent)),
                            united(corner(left, size.descent), corner(right, size.descent)));
    return {anchor, std::move(text), style, box};
}

std::vector<std::string> wrapped(const std::string& text, double size, double width, const Measure& measure) {
    std::vector<std::string> lines;
    if (text.empty()) return lines;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        wrap_line(std::string_view{text}.substr(begin, end - begin), size, width, measure, lines);
        begin = end + 1;
    }
    return lines;
}

bool overlap(const Rect& a, const Rect& b, double apart) {
    return a.left < b.right + apart && b.left < a.right + apart && a.top < b.bottom + apart &&
           b.top < a.bottom + apart;
}

Rect united(const Rect& a, const Rect& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

Rect grown(const Rect& rect, double by) {
    return {rect.left - by, rect.top - by, rect.right + by, rect.bottom + by};
}

}  // namespace plot
