#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "common/plot/canvas.hpp"

/// Measuring pictures that are drawn in black on white.
namespace picture {

inline const plot::Colour black{0, 0, 0, 1};

/// How black a pixel is, 0..1.
inline double ink_at(const plot::Image& image, int x, int y) {
    const auto at =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
    return (255.0 - image.rgb[3 * at]) / 255.0;
}

/// Sum of the ink, its centre, and the box of pixels that have more ink than `threshold`.
struct Ink {
    double sum = 0, x = 0, y = 0;
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
};
inline Ink ink(const plot::Image& image, double threshold = 0.02) {
    Ink result;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double amount = ink_at(image, x, y);
            result.sum += amount;
            result.x += amount * (x + 0.5);
            result.y += amount * (y + 0.5);
            if (amount <= threshold) continue;
            result.left = std::min(result.left, x);
            result.right = std::max(result.right, x);
            result.top = std::min(result.top, y);
            result.bottom = std::max(result.bottom, y);
        }
    result.x /= result.sum;
    result.y /= result.sum;
    return result;
}

inline int largest_difference(const plot::Image& a, const plot::Image& b) {
    int largest = a.rgb.size() == b.rgb.size() ? 0 : 255;
    for (std::size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); ++i)
        largest = std::max(largest, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    return largest;
}

/// What `draw(canvas)` leaves on a white picture.
template <class Draw>
plot::Image drawn(plot::Canvas& canvas, int width, int height, Draw draw) {
    canvas.begin(width, height);
    draw(canvas);
    return canvas.finish();
}

inline plot::Point on_circle(plot::Point centre, double radius, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
}

}  // namespace picture
