#include <algorithm>
#include <cmath>

#include "common/plot/canvas_implementation.hpp"
#include "common/plot/canvas_stroke.hpp"

namespace plot {

void Canvas::stroke(std::span<const Polyline> lines, double width, Colour colour,
                    std::span<const double> dashes) {
    Implementation& self = *self_;
    self.prepare();
    if (!(width > 0) || !std::isfinite(width)) return;
    const std::vector<Segment> segments = stroke_segments(lines, width, dashes, self.visible());
    const std::vector<PixelBox> touched = touched_boxes(segments, 0.5 * width + 1, self.clip);
    if (touched.empty()) return;

    if (!self.mask)
        self.mask.emplace(self.picture->width(), self.picture->height(), Surface::Format::coverage);
    self.mask->draw_here();
    glScissor(self.clip.left, self.clip.top, self.clip.width(), self.clip.height());
    glDisable(GL_BLEND);
    self.programs.flat.use(self.mask->width(), self.mask->height());
    self.programs.flat.set_colour("colour", {});
    self.draw_boxes(touched);
    // The largest coverage counts: pieces that overlap do not add up, neither at joints nor at crossings.
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    self.programs.capsules.use(self.mask->width(), self.mask->height());
    self.programs.capsules.set("half_width", static_cast<float>(0.5 * width));
    self.segments.draw_quads(segments.data(), segments.size());
    glBlendEquation(GL_FUNC_ADD);

    self.mask->read_here();
    self.draw_into_picture(self.programs.mask, self.clip);
    self.programs.mask.set_colour("colour", bytes(colour));
    self.draw_boxes(touched);
}

void Canvas::rule(Point from, Point to, double width, Colour colour) {
    const bool level = from.y == to.y, upright = from.x == to.x;
    if (!level && !upright) {
        const Polyline line{from, to};
        return stroke(std::span{&line, 1}, width, colour);
    }
    if (!(width > 0) || (level && upright)) return;
    const double thick = std::max(1.0, std::floor(width + 0.5));
    const double first = std::floor((level ? from.y : from.x) - 0.5 * thick + 0.5);
    const auto [low, high] = level ? std::minmax(from.x, to.x) : std::minmax(from.y, to.y);
    const Rect rect = level ? Rect{low, first, high, first + thick} : Rect{first, low, first + thick, high};
    rectangle(rect, colour);
}

void Canvas::rectangle(const Rect& rect, Colour colour) {
    self_->fill_box(nearest_pixels(rect), colour);
}

}  // namespace plot
