#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/plot/colour_map.hpp"
#include "common/plot/contour.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/number_text.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

/// Light on the dark parts of a filled field and the other way round; without filling dark enough for paper.
Colour line_colour(const Field& field, double level, const Range& range) {
    const Colour below =
        map_colour(field.bar.map, map_position(level, {range.low, range.high}, field.bar.scale));
    if (field.filled) return luminance(below) < 0.25 ? Colour{1, 1, 1, 0.85} : Colour{0.05, 0.05, 0.05, 0.8};
    Colour line = below;
    constexpr double readable = 0.35;
    while (luminance(line) > readable) line = mixed(line, {0, 0, 0, 1}, 0.1);
    return line;
}

/// A piece of a contour line that makes room for the label.
struct LabelPlace {
    std::size_t first = 0, last = 0;  // points of the line
    Point centre;
    double angle = 0;    // radians, counter-clockwise on paper, text upright
    double bend = 1.15;  // length of the piece over its chord: at most this
    bool found = false;
};

Rect around(Point centre, double length) {
    return grown({centre.x, centre.y, centre.x, centre.y}, length / 2);
}

/// The straightest piece of the wanted length whose label is inside the frame and hides no other.
LabelPlace label_place(const Polyline& line, double length, const Rect& frame,
                       const std::vector<Rect>& taken) {
    LabelPlace best;
    std::vector<double> along(line.size());
    for (std::size_t k = 1; k < line.size(); ++k)
        along[k] = along[k - 1] + std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
    if (line.size() < 2 || along.back() < 3 * length) return best;
    std::size_t last = 0;
    for (std::size_t first = 0; first < line.size(); ++first) {
        while (last < line.size() && along[last] < along[first] + length) ++last;
        if (last == line.size()) break;
        const Point a = line[first], b = line[last];
        const double bend = (along[last] - along[first]) / std::hypot(b.x - a.x, b.y - a.y);
        if (!(bend < best.bend - 1e-6)) continue;
        const Point centre{(a.x + b.x) / 2, (a.y + b.y) / 2};
        const Rect box = around(centre, length);
        const bool hides =
            std::any_of(taken.begin(), taken.end(), [&](const Rect& r) { return overlap(r, box); });
        if (hides || !contains(grown(frame, -0.7 * length), centre)) continue;
        double angle = std::atan2(a.y - b.y, b.x - a.x);
        // Upright, and steep labels all read upwards: -75 to 105 degrees.
        constexpr double lowest = -75 * std::numbers::pi / 180;
        if (angle < lowest) angle += std::numbers::pi;
        if (angle >= lowest + std::numbers::pi) angle -= std::numbers::pi;
        best = {first, last, centre, angle, bend, true};
    }
    return best;
}

class Contours {
  public:
    Contours(Canvas& canvas, const Field& field, const PanelLayout& layout)
        : canvas_{canvas}, field_{field}, layout_{layout}, range_{bar_range(field.bar, field.value)} {
        for (const auto& note : layout.notes) taken_.push_back(note.box);
        if (!layout.legend.items.empty()) taken_.push_back(layout.legend.box);
    }

    void draw(double level) {
        const Colour colour = line_colour(field_, level, range_);
        std::vector<Polyline> pieces;
        std::vector<TextBox> labels;
        for (const auto& contour : contour_lines(field_, level)) {
            Polyline line;
            for (const Point at : contour) line.push_back(pixel(at.x, at.y, layout_.x, layout_.y));
            if (field_.contour_labels) make_room(line, level, faded(colour, 1), pieces, labels);
            pieces.push_back(std::move(line));
        }
        std::vector<Polyline> seen;
        for (const auto& piece : pieces)
            for (auto& part : clipped(piece, grown(layout_.frame, 8))) seen.push_back(std::move(part));
        canvas_.stroke(seen, pixels_per_point, colour);
        for (const auto& label : labels) draw_text(canvas_, label);
    }

  private:
    /// Cuts a piece out of the line, if one suits, and puts the label there.
    void make_room(Polyline& line, double level, Colour colour, std::vector<Polyline>& pieces,
                   std::vector<TextBox>& labels) {
        TextStyle style{.size = 8 * pixels_per_point, .colour = colour, .horizontal = Anchor::centre};
        const std::string text = short_number(level, 6);
        const double length = canvas_.measure(text, style.size).width + 0.8 * style.size;
        const LabelPlace place = label_place(line, length, layout_.frame, taken_);
        if (!place.found) return;
        style.angle = place.angle * 180 / std::numbers::pi;
        const double down = cap_height / 2 * style.size;
        const Point anchor{place.centre.x + std::sin(place.angle) * down,
                           place.centre.y + std::cos(place.angle) * down};
        const Measure measure = [this](std::string_view t, double size) { return canvas_.measure(t, size); };
        labels.push_back(text_box(anchor, text, style, measure));
        taken_.push_back(around(place.centre, length));
        const auto at = [&line](std::size_t k) { return line.begin() + static_cast<std::ptrdiff_t>(k); };
        pieces.emplace_back(line.begin(), at(place.first + 1));
        line.erase(line.begin(), at(place.last));
    }

    Canvas& canvas_;
    const Field& field_;
    const PanelLayout& layout_;
    Range range_;
    std::vector<Rect> taken_;  // by labels and notes
};

}  // namespace

void draw_contours(Canvas& canvas, const Field& field, const PanelLayout& layout) {
    Contours contours{canvas, field, layout};
    for (const double level : field.contours) contours.draw(level);
}

}  // namespace plot
