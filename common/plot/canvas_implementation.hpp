#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/plot/canvas_boxes.hpp"
#include "common/plot/canvas_surface.hpp"
#include "common/plot/context.hpp"
#include "common/plot/glyphs_atlas.hpp"
#include "common/plot/glyphs_font.hpp"
#include "common/plot/shaders.hpp"

namespace plot {

using Bytes4 = std::array<std::uint8_t, 4>;
/// Red, green, blue, alpha; each rounded to 0..255.
Bytes4 bytes(const Colour& colour);

/// What is sent to OpenGL: a coloured point (vertex of a triangle, or disc) and a glyph.
struct ColouredPoint {
    float x, y;
    Bytes4 colour;
};
struct GlyphQuad {
    float x, y, width, height;
    float texel_x, texel_y;
    Bytes4 colour;
};

/// Objects that last as long as the canvas; the context is made before all of them and goes after them.
struct Canvas::Implementation {
    Implementation();

    /// Makes the context current and draws what waits; every drawing call begins so. Throws std::logic_error
    /// if no picture has been begun.
    void prepare();
    /// Directs drawing to the picture's pixels in `box`, with `program`.
    void draw_into_picture(const Program& program, const PixelBox& box);
    void fill_box(const PixelBox& box, const Colour& colour);
    void draw_boxes(std::span<const PixelBox> boxes);
    void draw_tile(const PixelBox& box);
    void queue(const AtlasGlyph& glyph, int x, int y, const Bytes4& colour);
    void draw_waiting_text();
    Rect visible() const;

    Font font;
    Context context;
    Programs programs;
    VertexStream boxes, segments, coloured_quads, coloured_vertices, plain_quads, glyph_quads;
    GlyphAtlas atlas;
    std::optional<Surface> picture, mask, tile;
    PixelBox clip;
    std::vector<GlyphQuad> waiting_text;  // drawn together: one call for many labels
};

}  // namespace plot
