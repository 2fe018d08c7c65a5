#include "common/plot/glyphs_atlas.hpp"

#include <algorithm>

namespace plot {

std::optional<AtlasGlyph> GlyphAtlas::find(const Font& font, const GlyphStyle& style) {
    if (const auto known = glyphs_.find(style); known != glyphs_.end()) return known->second;
    const GlyphBitmap bitmap = font.bitmap(style);
    AtlasGlyph glyph{bitmap.left, bitmap.top, bitmap.width, bitmap.height, 0, 0};
    if (!place(glyph)) return std::nullopt;
    coverage_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (int row = 0; row < glyph.height; ++row)
        std::copy_n(bitmap.coverage.begin() + std::ptrdiff_t{row} * glyph.width, glyph.width,
                    coverage_.begin() + std::ptrdiff_t{glyph.y + row} * side_ + glyph.x);
    changed_ = true;
    glyphs_.emplace(style, glyph);
    return glyph;
}

bool GlyphAtlas::place(AtlasGlyph& glyph) {
    if (shelf_end_ + glyph.width > side_) {
        shelf_top_ += shelf_height_;
        shelf_height_ = shelf_end_ = 0;
    }
    if (glyph.width > side_ || shelf_top_ + glyph.height > side_) return false;
    glyph.x = shelf_end_;
    glyph.y = shelf_top_;
    shelf_end_ += glyph.width;
    shelf_height_ = std::max(shelf_height_, glyph.height);
    return true;
}

void GlyphAtlas::clear(const Font& font, const GlyphStyle& style) {
    const GlyphBitmap bitmap = font.bitmap(style);
    while (side_ < std::max(bitmap.width, bitmap.height)) side_ *= 2;
    shelf_top_ = shelf_height_ = shelf_end_ = 0;
    glyphs_.clear();
    coverage_.clear();
    changed_ = true;
}

void GlyphAtlas::read_here() {
    if (!texture_ || texture_->width() != side_) texture_.emplace(side_, side_, Surface::Format::coverage);
    if (changed_) {
        coverage_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        texture_->load(coverage_.data());
        changed_ = false;
    }
    texture_->read_here();
}

}  // namespace plot
