#pragma once
#include <array>
#include <cstdint>

#include "common/plot/context_gl.hpp"

namespace plot {

/// A compiled and linked pair of shaders. Needs a current context as long as it lives.
class Program {
  public:
    /// Throws std::logic_error with the compiler's message.
    Program(const char* vertex_source, const char* fragment_source);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Draws with it from now on, into a target of `width` x `height` pixels.
    void use(int width, int height) const;
    void set(const char* uniform, float a) const;
    void set(const char* uniform, float a, float b) const;
    void set(const char* uniform, int a) const;
    /// Red, green, blue, alpha as bytes; premultiplied here.
    void set_colour(const char* uniform, const std::array<std::uint8_t, 4>& colour) const;

  private:
    GLint location(const char* uniform) const;
    GLuint id_;
};

/// All programs of the canvas. Coordinates are pixels, colours leave premultiplied by their alpha.
struct Programs {
    Programs();
    Program capsules;   ///< coverage of round-capped segments, for the stroke mask
    Program mask;       ///< a box of one colour, seen through the stroke mask
    Program flat;       ///< a box of one colour
    Program triangles;  ///< coloured triangles in a magnified tile
    Program resolve;    ///< a magnified tile, averaged 4x4
    Program discs;
    Program markers;
    Program glyphs;
};

}  // namespace plot
