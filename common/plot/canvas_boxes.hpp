#pragma once
#include "common/plot/canvas.hpp"

namespace plot {

constexpr int largest_side = 16384;  ///< of a picture, in pixels

/// Whole pixels: left and top belong to it, right and bottom do not.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
    bool empty() const noexcept { return left >= right || top >= bottom; }
    int width() const noexcept { return right - left; }
    int height() const noexcept { return bottom - top; }
};
PixelBox common_part(const PixelBox& a, const PixelBox& b);
/// The nearest whole pixels to `rect`, cut to 0..16384; a side that is not a number becomes 0.
PixelBox nearest_pixels(const Rect& rect);
/// The fewest pixels that cover `rect`, likewise.
PixelBox covering_pixels(const Rect& rect);

}  // namespace plot
