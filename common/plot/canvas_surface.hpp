#pragma once
#include <cstddef>
#include <initializer_list>

#include "common/plot/context_gl.hpp"

namespace plot {

/// Pixels to draw into and to read from: a texture with its framebuffer. Needs a current context as long as
/// it lives.
class Surface {
  public:
    enum class Format { colour, coverage };  ///< RGBA or one channel, 8 bits each

    /// 1..16384 texels each way. Throws app::IoError if OpenGL has no memory for it.
    Surface(int width, int height, Format format);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    int width() const noexcept { return width_; }
    int height() const noexcept { return height_; }
    void draw_here() const;  ///< drawing goes here from now on
    void read_here() const;  ///< shaders read it as `image` from now on
    /// Replaces all texels (coverage only), row by row.
    void load(const void* bytes) const;

  private:
    int width_, height_;
    Format format_;
    GLuint texture_ = 0, framebuffer_ = 0;
};

/// One input of a vertex shader; its location is its place in the list.
struct Attribute {
    GLint components;
    GLenum type;
    bool normalised;  ///< integers mean 0..1
    std::size_t offset;
};

/// A buffer on OpenGL's side that takes vertices, or instances of quads, for one draw call after the other.
class VertexStream {
  public:
    enum class Step { vertex, quad };
    VertexStream(std::size_t stride, std::initializer_list<Attribute> attributes, Step step);
    ~VertexStream();
    VertexStream(const VertexStream&) = delete;
    VertexStream& operator=(const VertexStream&) = delete;

    void load(const void* data, std::size_t count) const;
    /// Loads and draws `count` quads.
    void draw_quads(const void* data, std::size_t count) const;
    /// Draws triangles of the loaded vertices.
    void draw_triangles(const unsigned* indices, std::size_t count) const;

  private:
    std::size_t stride_;
    GLuint array_ = 0, vertices_ = 0, indices_ = 0;
};

}  // namespace plot
