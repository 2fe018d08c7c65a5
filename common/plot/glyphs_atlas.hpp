#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/plot/canvas_surface.hpp"
#include "common/plot/glyphs_font.hpp"

namespace plot {

/// Where a glyph's coverage lies in the atlas, and from where it is drawn: see GlyphBitmap.
struct AtlasGlyph {
    int left = 0, top = 0, width = 0, height = 0;
    int x = 0, y = 0;
};

/// All glyphs drawn so far, side by side in one texture, in shelves: rows of glyphs of about one height.
class GlyphAtlas {
  public:
    /// Empty when it is full: draw what is waiting, then clear() and ask again.
    std::optional<AtlasGlyph> find(const Font& font, const GlyphStyle& style);
    /// Forgets all glyphs, and has room for one as large as `style` at least.
    void clear(const Font& font, const GlyphStyle& style);
    /// Brings the texture up to date and lets shaders read it.
    void read_here();

  private:
    bool place(AtlasGlyph& glyph);

    int side_ = 1024;
    int shelf_top_ = 0, shelf_height_ = 0, shelf_end_ = 0;
    bool changed_ = true;
    std::vector<std::uint8_t> coverage_;
    std::map<GlyphStyle, AtlasGlyph> glyphs_;
    std::optional<Surface> texture_;
};

}  // namespace plot
