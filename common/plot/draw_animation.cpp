#include "common/plot/draw_animation.hpp"

#include "common/plot/draw_figure.hpp"

namespace plot {

Image draw_frame(Canvas& canvas, const Animation& animation, std::size_t k) {
    Image image = draw(canvas, animation.shown(k));
    return image.width > widest_frame ? halved(image) : image;
}

Image halved(const Image& image) {
    Image half{image.width / 2, image.height / 2, {}};
    const auto width = static_cast<std::size_t>(half.width), height = static_cast<std::size_t>(half.height);
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    half.rgb.reserve(3 * width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* upper = image.rgb.data() + 2 * y * stride;
        const std::uint8_t* lower = upper + stride;
        for (std::size_t x = 0; x < width; ++x, upper += 6, lower += 6)
            for (std::size_t c = 0; c < 3; ++c)
                half.rgb.push_back(
                    static_cast<std::uint8_t>((upper[c] + upper[c + 3] + lower[c] + lower[c + 3] + 2) / 4));
    }
    return half;
}

}  // namespace plot
