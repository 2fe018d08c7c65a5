#include "common/plot/canvas_boxes.hpp"

#include <algorithm>
#include <cmath>

namespace plot {
namespace {

int whole(double value) {
    return static_cast<int>(std::clamp(std::isnan(value) ? 0.0 : value, 0.0, double{largest_side}));
}

}  // namespace

PixelBox common_part(const PixelBox& a, const PixelBox& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

PixelBox nearest_pixels(const Rect& rect) {
    const auto near = [](double value) { return whole(std::floor(value + 0.5)); };
    return {near(rect.left), near(rect.top), near(rect.right), near(rect.bottom)};
}

PixelBox covering_pixels(const Rect& rect) {
    return {whole(std::floor(rect.left)), whole(std::floor(rect.top)), whole(std::ceil(rect.right)),
            whole(std::ceil(rect.bottom))};
}

}  // namespace plot
