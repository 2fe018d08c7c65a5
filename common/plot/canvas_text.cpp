#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/plot/canvas_implementation.hpp"
#include "common/plot/glyphs_layout.hpp"

namespace plot {
namespace {

constexpr double largest_text = 2048;  // pixels per em

void require_size(double size) {
    if (!(size > 0 && size <= largest_text))
        throw std::invalid_argument{"text has a size of more than 0 and at most 2048 pixels"};
}

/// A coordinate as a whole pixel and quarters of one.
struct Snapped {
    int pixel = 0, quarters = 0;
};

Snapped snap_to_quarter(double value) {
    const double quarters = std::floor(value * 4 + 0.5);
    const double pixel = std::floor(quarters / 4);
    return {static_cast<int>(pixel), static_cast<int>(quarters - 4 * pixel)};
}
Snapped snap_to_pixel(double value) {
    return {static_cast<int>(std::floor(value + 0.5)), 0};
}

/// The direction of a baseline on the picture, where y grows downwards. Exact for multiples of 90 degrees.
struct LineDirection {
    explicit LineDirection(double degrees) {
        const double turned = std::remainder(degrees, 360.0);
        angle = static_cast<int>(std::lround(turned * 64));
        level = angle % (180 * 64) == 0;
        upright = !level && angle % (90 * 64) == 0;
        const double radians = turned * std::numbers::pi / 180;
        x = upright ? 0 : std::cos(radians);
        y = level ? 0 : -std::sin(radians);
    }
    int angle = 0;  ///< 1/64 degrees
    double x = 1, y = 0;
    bool level = true, upright = false;
};

}  // namespace

TextSize Canvas::measure(std::string_view text, double size) const {
    require_size(size);
    return lay_out(self_->font, text, size).extent;
}

void Canvas::text(Point anchor, std::string_view text, const TextStyle& style) {
    require_size(style.size);
    Implementation& self = *self_;
    if (!self.picture) self.prepare();
    constexpr double far = 1e6;  // beyond that nothing is visible, and pixels would not fit an int
    if (!(std::abs(anchor.x) < far && std::abs(anchor.y) < far) || !std::isfinite(style.angle)) return;
    const TextLine line = lay_out(self.font, text, style.size);
    const LineDirection direction{style.angle};
    const Point start = alignment(line.extent, style);
    for (const PlacedGlyph& placed : line.glyphs) {
        const double along = start.x + placed.x, up = start.y + placed.y;
        const double x = anchor.x + along * direction.x + up * direction.y;
        const double y = anchor.y + along * direction.y - up * direction.x;
        const Snapped at_x = direction.upright ? snap_to_pixel(x) : snap_to_quarter(x);
        const Snapped at_y = direction.level ? snap_to_pixel(y) : snap_to_quarter(y);
        const GlyphStyle glyph{placed.glyph,  static_cast<int>(std::lround(placed.size * 64)),
                               placed.italic, direction.angle,
                               at_x.quarters, at_y.quarters};
        auto found = self.atlas.find(self.font, glyph);
        if (!found) {
            self.prepare();
            self.atlas.clear(self.font, glyph);
            found = self.atlas.find(self.font, glyph);
        }
        if (found) self.queue(*found, at_x.pixel, at_y.pixel, bytes(style.colour));
    }
}

void Canvas::Implementation::queue(const AtlasGlyph& glyph, int x, int y, const Bytes4& colour) {
    const int left = x + glyph.left, top = y + glyph.top;
    // Cut to the clip now: it may have changed when the text is drawn.
    const PixelBox part = common_part({left, top, left + glyph.width, top + glyph.height}, clip);
    if (part.empty()) return;
    const auto real = [](int value) { return static_cast<float>(value); };
    waiting_text.push_back({real(part.left), real(part.top), real(part.width()), real(part.height()),
                            real(glyph.x + part.left - left), real(glyph.y + part.top - top), colour});
}

void Canvas::Implementation::draw_waiting_text() {
    if (waiting_text.empty()) return;
    atlas.read_here();
    draw_into_picture(programs.glyphs, {0, 0, picture->width(), picture->height()});
    glyph_quads.draw_quads(waiting_text.data(), waiting_text.size());
    waiting_text.clear();
}

}  // namespace plot
