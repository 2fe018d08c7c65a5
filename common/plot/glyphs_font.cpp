#include "common/plot/glyphs_font.hpp"

#include <fmt/format.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "common/app/error.hpp"

namespace plot {
namespace {

constexpr double slant = 0.2;  // of italics: 11 degrees, that of DejaVu Sans Oblique
constexpr double fixed = 65536;
constexpr int right_angle = 90 * 64;

FT_Fixed to_fixed(double value) {
    return static_cast<FT_Fixed>(std::lround(value * fixed));
}

std::string font_file() {
    const char* chosen = std::getenv("SPH_FONT");
    return chosen != nullptr && *chosen != '\0' ? chosen : SPH_DEFAULT_FONT;
}

/// Shear first, then rotation by `degrees`, counter-clockwise.
FT_Matrix transformation(bool italic, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle), k = italic ? slant : 0;
    return {to_fixed(c), to_fixed(c * k - s), to_fixed(s), to_fixed(s * k + c)};
}

}  // namespace

struct Font::Handle {
    std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)> library{nullptr, &FT_Done_FreeType};
    std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)> face{nullptr, &FT_Done_Face};

    void check(FT_Error error, const char* what) const {
        if (error != 0) throw std::runtime_error{fmt::format("FreeType: {} failed (error {})", what, error)};
    }
    void load(unsigned glyph, int size, FT_Int32 flags) const {
        constexpr int dots_per_inch = 72;  // so that sizes in points are sizes in pixels
        check(FT_Set_Char_Size(face.get(), 0, size, dots_per_inch, dots_per_inch), "setting the size");
        check(FT_Load_Glyph(face.get(), glyph, flags | FT_LOAD_NO_BITMAP), "loading a glyph");
    }
    /// Loads without hinting at a size where rounding is negligible; returns the factor to `size`.
    double load_large(unsigned glyph, double size) const {
        constexpr int large = 1024;
        load(glyph, large * 64, FT_LOAD_NO_HINTING);
        return size / large;
    }
};

Font::Font() : handle_{std::make_unique<Handle>()} {
    FT_Library library = nullptr;
    handle_->check(FT_Init_FreeType(&library), "initialisation");
    handle_->library.reset(library);
    const std::string file = font_file();
    FT_Face face = nullptr;
    if (FT_New_Face(library, file.c_str(), 0, &face) != 0)
        throw app::IoError{"cannot read the font " + file +
                           "; on Debian: apt-get install fonts-dejavu-core, or name another in SPH_FONT"};
    handle_->face.reset(face);
    if (!FT_IS_SCALABLE(face)) throw app::IoError{"the font " + file + " has no outlines"};
}

Font::~Font() = default;

unsigned Font::glyph(char32_t code) const {
    return FT_Get_Char_Index(handle_->face.get(), code);
}

double Font::advance(unsigned glyph, double size) const {
    const double scale = handle_->load_large(glyph, size);
    return static_cast<double>(handle_->face->glyph->linearHoriAdvance) / fixed * scale;
}

double Font::kerning(unsigned left, unsigned right, double size) const {
    FT_Vector gap{};
    handle_->check(FT_Get_Kerning(handle_->face.get(), left, right, FT_KERNING_UNSCALED, &gap), "kerning");
    return size * static_cast<double>(gap.x) / handle_->face->units_per_EM;
}

GlyphBox Font::box(unsigned glyph, double size, bool italic) const {
    const double scale = handle_->load_large(glyph, size) / 64;
    FT_Outline* outline = &handle_->face->glyph->outline;
    const FT_Matrix matrix = transformation(italic, 0);
    FT_Outline_Transform(outline, &matrix);
    FT_BBox box;
    FT_Outline_Get_CBox(outline, &box);
    const auto pixels = [scale](FT_Pos value) { return static_cast<double>(value) * scale; };
    return {pixels(box.xMin), pixels(box.yMin), pixels(box.xMax), pixels(box.yMax)};
}

GlyphBitmap Font::bitmap(const GlyphStyle& style) const {
    const bool parallel = style.angle % right_angle == 0;
    handle_->load(style.glyph, style.size, parallel ? FT_LOAD_TARGET_LIGHT : FT_LOAD_NO_HINTING);
    FT_GlyphSlot slot = handle_->face->glyph;
    const FT_Matrix matrix = transformation(style.italic, style.angle / 64.0);
    FT_Outline_Transform(&slot->outline, &matrix);
    constexpr int quarter = 16;
    FT_Outline_Translate(&slot->outline, style.x * quarter, -style.y * quarter);
    handle_->check(FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL), "rendering a glyph");

    const FT_Bitmap& source = slot->bitmap;
    GlyphBitmap result{slot->bitmap_left,
                       -slot->bitmap_top,
                       static_cast<int>(source.width),
                       static_cast<int>(source.rows),
                       {}};
    result.coverage.reserve(std::size_t{source.width} * source.rows);
    for (unsigned row = 0; row < source.rows; ++row) {
        const auto* bytes = source.buffer + static_cast<std::ptrdiff_t>(row) * source.pitch;
        result.coverage.insert(result.coverage.end(), bytes, bytes + source.width);
    }
    return result;
}

}  // namespace plot
