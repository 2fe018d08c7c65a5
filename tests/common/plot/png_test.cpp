#include <catch2/catch.hpp>
#include <cstdint>

#include "common/plot/png_file.hpp"

using plot::decode_png;
using plot::encode_png;
using plot::Image;
using plot::PngTexts;

namespace {

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i)
        image.rgb.push_back(static_cast<std::uint8_t>(i * 7 + i / 300));
    return image;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = (value << 8) | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

/// Names of the chunks, in order; `data` becomes where the last of name `wanted` begins.
std::vector<std::string> chunks(const std::string& png, const std::string& wanted = {},
                                std::size_t* data = nullptr) {
    std::vector<std::string> names;
    for (std::size_t at = 8; at + 12 <= png.size(); at += 12 + number_at(png, at)) {
        names.push_back(png.substr(at + 4, 4));
        if (names.back() == wanted) *data = at + 8;
    }
    return names;
}

}  // namespace

TEST_CASE("a PNG gives back its image and its texts") {
    const PngTexts texts{{"Title", "Sod tube, γ = 1.4 — Δx"}, {"Software", "sph"}, {"Comment", ""}};
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {640, 480}, {3, 5000}}) {
        const Image image = gradient(width, height);
        PngTexts read;
        const Image back = decode_png(encode_png(image, texts, 144), &read);
        CHECK(back.width == width);
        CHECK(back.height == height);
        CHECK(back.rgb == image.rgb);  // fails if rows or channels are swapped
        CHECK(read == texts);          // fails if texts are written as Latin-1
    }
    CHECK(decode_png(encode_png(gradient(4, 4), {}, 72)).rgb == gradient(4, 4).rgb);
}

TEST_CASE("a PNG has sRGB, resolution and UTF-8 texts, but no date") {
    const std::string png = encode_png(gradient(20, 20), {{"Title", "γ"}}, 144);
    std::size_t at = 0;
    CHECK(chunks(png, "pHYs", &at) ==
          std::vector<std::string>{"IHDR", "sRGB", "pHYs", "iTXt", "IDAT", "IEND"});
    CHECK(number_at(png, at) == 5669);  // 144 / 0.0254 a metre; fails (144) if inches are taken for metres
    CHECK(number_at(png, at + 4) == 5669);
    CHECK(png[at + 8] == 1);
    CHECK(encode_png(gradient(20, 20), {{"Title", "γ"}}, 144) == png);
}

TEST_CASE("what is no PNG, or no image, is an error that says so") {
    const std::string png = encode_png(gradient(50, 50), {}, 72);
    CHECK_THROWS_WITH(decode_png(""), Catch::Contains("PNG: "));
    CHECK_THROWS_WITH(decode_png("not a picture, but long enough"), Catch::Contains("PNG"));
    CHECK_THROWS_WITH(decode_png(png.substr(0, png.size() / 2)), Catch::Contains("too early"));
    std::string damaged = png;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 0x55);
    CHECK_THROWS_AS(decode_png(damaged), std::runtime_error);
    CHECK_THROWS_AS(encode_png({3, 3, {1, 2, 3}}, {}, 72), std::runtime_error);
    CHECK_THROWS_AS(encode_png({0, 0, {}}, {}, 72), std::runtime_error);
    CHECK_THROWS_AS(encode_png(gradient(2, 2), {{"", "no keyword"}}, 72), std::runtime_error);
    CHECK_THROWS_AS(encode_png(gradient(2, 2), {{std::string(80, 'k'), "long keyword"}}, 72),
                    std::runtime_error);
}
