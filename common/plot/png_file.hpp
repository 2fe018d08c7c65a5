#pragma once
#include <string>
#include <utility>
#include <vector>

#include "common/plot/canvas.hpp"

namespace plot {

/// (keyword, UTF-8 text) pairs for the PNG's iTXt chunks.
using PngTexts = std::vector<std::pair<std::string, std::string>>;

/// The image as the bytes of a PNG file: zlib level 6, sRGB and pHYs chunks (`pixels_per_inch`), the texts as
/// iTXt, no time stamp. Throws std::runtime_error with libpng's message.
std::string encode_png(const Image& image, const PngTexts& texts, double pixels_per_inch);
/// The image and texts of a PNG file. Throws std::runtime_error with libpng's message.
Image decode_png(const std::string& bytes, PngTexts* texts = nullptr);

}  // namespace plot
