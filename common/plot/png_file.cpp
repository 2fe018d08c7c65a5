#include "common/plot/png_file.hpp"

#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>

namespace plot {
namespace {

/// What libpng says before it jumps back. C's jumps skip destructors, so the functions that set the jump own
/// nothing that needs one: they take pointers, and return whether all went well.
struct Report {
    std::array<char, 256> text{};
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto& report = *static_cast<Report*>(png_get_error_ptr(png));
    std::strncpy(report.text.data(), message, report.text.size() - 1);
    png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}
void no_flush(png_structp) {}

void take(png_structp png, png_bytep data, std::size_t size) {
    auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest.size()) png_error(png, "the file ends too early");
    std::memcpy(data, rest.data(), size);
    rest.remove_prefix(size);
}

struct Writer {
    Report report;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &report, on_error, on_warning);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    Writer() = default;
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};
struct Reader {
    Report report;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &report, on_error, on_warning);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    Reader() = default;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

template <class Side>
void require(const Side& side, bool done) {
    if (side.info == nullptr) throw std::runtime_error{"PNG: libpng has no memory"};
    if (!done) throw std::runtime_error{std::string{"PNG: "} + side.report.text.data()};
}

bool write(Writer& writer, const Image& image, png_uint_32 pixels_per_metre, png_text* texts, int count) {
    png_structp png = writer.png;
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    constexpr int level = 6;
    png_set_compression_level(png, level);
    // Figures are flat areas with sharp edges: unfiltered rows are packed smaller (8-15 %) and in half the
    // time.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_pHYs(png, writer.info, pixels_per_metre, pixels_per_metre, PNG_RESOLUTION_METER);
    png_set_text(png, writer.info, texts, count);
    png_write_info(png, writer.info);
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row)
        png_write_row(png, image.rgb.data() + row * stride);
    png_write_end(png, writer.info);
    return true;
}

bool read_header(Reader& reader, Image& image) {
    png_structp png = reader.png;
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_info(png, reader.info);
    png_set_expand(png);
    png_set_strip_16(png);
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, reader.info);
    image.width = static_cast<int>(png_get_image_width(png, reader.info));
    image.height = static_cast<int>(png_get_image_height(png, reader.info));
    return true;
}

bool read_rows(Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, reader.info);
    return true;
}

PngTexts texts_of(const Reader& reader) {
    png_textp texts = nullptr;
    const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
    PngTexts result;
    for (int i = 0; i < count; ++i) {
        const bool utf8 = texts[i].compression >= PNG_ITXT_COMPRESSION_NONE;
        const std::size_t size = utf8 ? texts[i].itxt_length : texts[i].text_length;
        result.emplace_back(texts[i].key, size == 0 ? std::string{} : std::string{texts[i].text, size});
    }
    return result;
}

}  // namespace

std::string encode_png(const Image& image, const PngTexts& texts, double pixels_per_inch) {
    const std::size_t size =
        3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || image.rgb.size() != size)
        throw std::runtime_error{"PNG: the image's size and the number of its pixels differ"};
    PngTexts copies = texts;  // libpng wants pointers to char that is not const
    std::vector<png_text> chunks(copies.size());
    std::string language;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        constexpr std::size_t longest = 79;  // longer ones libpng would cut off without an error
        if (copies[i].first.empty() || copies[i].first.size() > longest)
            throw std::runtime_error{"PNG: a keyword has 1 to 79 characters, not \"" + copies[i].first + '"'};
        chunks[i].compression = PNG_ITXT_COMPRESSION_NONE;
        chunks[i].key = copies[i].first.data();
        chunks[i].text = copies[i].second.data();
        chunks[i].lang = chunks[i].lang_key = language.data();
    }
    constexpr double metres_per_inch = 0.0254;
    const auto density = static_cast<png_uint_32>(std::lround(pixels_per_inch / metres_per_inch));
    std::string bytes;
    Writer writer;
    require(writer, true);
    png_set_write_fn(writer.png, &bytes, append, no_flush);
    require(writer, write(writer, image, density, chunks.data(), static_cast<int>(chunks.size())));
    return bytes;
}

Image decode_png(const std::string& bytes, PngTexts* texts) {
    std::string_view rest = bytes;
    Image image;
    Reader reader;
    require(reader, true);
    png_set_read_fn(reader.png, &rest, take);
    require(reader, read_header(reader, image));
    const std::size_t stride = png_get_rowbytes(reader.png, reader.info);
    image.rgb.resize(stride * static_cast<std::size_t>(image.height));
    std::vector<png_bytep> rows(static_cast<std::size_t>(image.height));
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = image.rgb.data() + row * stride;
    require(reader, read_rows(reader, rows.data()));
    if (texts != nullptr) *texts = texts_of(reader);
    return image;
}

}  // namespace plot
