#include "common/plot/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/app/error.hpp"
#include "common/plot/canvas_implementation.hpp"

namespace plot {
Bytes4 bytes(const Colour& colour) {
    const auto byte = [](double value) {
        return static_cast<std::uint8_t>(std::clamp(std::isnan(value) ? 0.0 : value, 0.0, 1.0) * 255 + 0.5);
    };
    return {byte(colour.red), byte(colour.green), byte(colour.blue), byte(colour.alpha)};
}

Canvas::Implementation::Implementation()
    : boxes{sizeof(PixelBox), {{4, GL_INT, GL_FALSE, 0}}, VertexStream::Step::quad},
      segments{4 * sizeof(float), {{4, GL_FLOAT, GL_FALSE, 0}}, VertexStream::Step::quad},
      coloured_quads{sizeof(ColouredPoint),
                     {{2, GL_FLOAT, GL_FALSE, 0}, {4, GL_UNSIGNED_BYTE, GL_TRUE, 2 * sizeof(float)}},
                     VertexStream::Step::quad},
      coloured_vertices{sizeof(ColouredPoint),
                        {{2, GL_FLOAT, GL_FALSE, 0}, {4, GL_UNSIGNED_BYTE, GL_TRUE, 2 * sizeof(float)}},
                        VertexStream::Step::vertex},
      plain_quads{2 * sizeof(float), {{2, GL_FLOAT, GL_FALSE, 0}}, VertexStream::Step::quad},
      glyph_quads{sizeof(GlyphQuad),
                  {{4, GL_FLOAT, GL_FALSE, 0},
                   {2, GL_FLOAT, GL_FALSE, 4 * sizeof(float)},
                   {4, GL_UNSIGNED_BYTE, GL_TRUE, 6 * sizeof(float)}},
                  VertexStream::Step::quad} {
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

void Canvas::Implementation::prepare() {
    if (!picture) throw std::logic_error{"nothing can be drawn before Canvas::begin"};
    context.make_current();
    draw_waiting_text();
}

void Canvas::Implementation::draw_into_picture(const Program& program, const PixelBox& box) {
    picture->draw_here();
    glScissor(box.left, box.top, box.width(), box.height());
    program.use(picture->width(), picture->height());
}

void Canvas::Implementation::fill_box(const PixelBox& box, const Colour& colour) {
    prepare();
    const PixelBox part = common_part(box, clip);
    if (part.empty()) return;
    draw_into_picture(programs.flat, part);
    programs.flat.set_colour("colour", bytes(colour));
    draw_boxes({&part, 1});
}

void Canvas::Implementation::draw_boxes(std::span<const PixelBox> list) {
    boxes.draw_quads(list.data(), list.size());
}

Rect Canvas::Implementation::visible() const {
    return {double(clip.left), double(clip.top), double(clip.right), double(clip.bottom)};
}

Canvas::Canvas() : self_{std::make_unique<Implementation>()} {}

Canvas::~Canvas() {
    self_->context.make_current();
}

void Canvas::begin(int width, int height) {
    if (width < 1 || height < 1 || width > largest_side || height > largest_side)
        throw std::invalid_argument{"a picture has 1 to 16384 pixels each way"};
    Implementation& self = *self_;
    self.context.make_current();
    self.waiting_text.clear();
    if (!self.picture || self.picture->width() != width || self.picture->height() != height) {
        self.mask.reset();
        self.picture.reset();
        self.picture.emplace(width, height, Surface::Format::colour);
    }
    unclip();
    self.picture->draw_here();
    glScissor(0, 0, width, height);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

Image Canvas::finish() {
    Implementation& self = *self_;
    self.prepare();
    Image image{self.picture->width(), self.picture->height(), {}};
    image.rgb.resize(std::size_t{3} * static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height));
    self.picture->draw_here();
    glReadPixels(0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    if (glGetError() != GL_NO_ERROR) throw app::IoError{"OpenGL has not enough memory for the picture"};
    return image;
}

void Canvas::clip(const Rect& rect) {
    unclip();
    self_->clip = common_part(nearest_pixels(rect), self_->clip);
}

void Canvas::unclip() {
    if (!self_->picture) throw std::logic_error{"nothing can be clipped before Canvas::begin"};
    self_->clip = {0, 0, self_->picture->width(), self_->picture->height()};
}

std::string Canvas::renderer() const {
    return self_->context.description();
}

}  // namespace plot
