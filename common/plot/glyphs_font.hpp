#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace plot {

/// How one glyph is drawn.
struct GlyphStyle {
    unsigned glyph = 0;   ///< number in the font
    int size = 0;         ///< 1/64 pixels per em
    bool italic = false;  ///< by shear
    int angle = 0;        ///< 1/64 degrees, counter-clockwise
    int x = 0, y = 0;     ///< quarters of a pixel, 0..3: where in the pixel its origin lies
    auto operator<=>(const GlyphStyle&) const = default;  // NOLINT(modernize-use-nullptr): of its own 0
};

/// Coverage of pixels, 0..255, row by row from the top; the glyph's origin lies in pixel (-left, -top).
struct GlyphBitmap {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<std::uint8_t> coverage;
};

/// Box of a glyph's outline around its origin, y upwards.
struct GlyphBox {
    double left = 0, bottom = 0, right = 0, top = 0;
};

/// The font of all figures, read by FreeType. Sizes are in pixels per em.
class Font {
  public:
    /// The file named by the environment variable SPH_FONT, else the one chosen when CMake ran (DejaVu Sans).
    /// Throws app::IoError naming the file and the Debian package.
    Font();
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    unsigned glyph(char32_t code) const;  ///< 0, an empty box, if the font has none
    /// How far the pen moves, and by how much less between two glyphs (without hinting, so any size is the
    /// same but for its scale).
    double advance(unsigned glyph, double size) const;
    double kerning(unsigned left, unsigned right, double size) const;
    GlyphBox box(unsigned glyph, double size, bool italic) const;
    /// Lightly hinted (its horizontal edges snap to pixels) where the baseline is parallel to an axis.
    GlyphBitmap bitmap(const GlyphStyle& style) const;

  private:
    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace plot
