#include "common/plot/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace plot {
namespace {

struct Stop {
    int index;     // in the published table
    unsigned rgb;  // 0xRRGGBB
};

constexpr Stop viridis_stops[] = {
    {0, 0x440154},   {18, 0x481b6d},  {34, 0x472f7d},  {52, 0x404588},  {82, 0x32658e},  {127, 0x21908d},
    {141, 0x1e9d89}, {153, 0x22a884}, {166, 0x2fb47c}, {180, 0x46c06f}, {195, 0x65cb5e}, {215, 0x95d840},
    {234, 0xc8e020}, {242, 0xdde318}, {248, 0xece51b}, {254, 0xfbe723}, {255, 0xfde725}};

constexpr Stop magma_stops[] = {
    {0, 0x000004},   {6, 0x02020d},   {20, 0x0e0b2b},  {34, 0x20114b},  {45, 0x311165},  {54, 0x400f74},
    {66, 0x54137d},  {84, 0x701f81},  {105, 0x912b81}, {131, 0xbc3978}, {150, 0xd9466b}, {163, 0xea5661},
    {174, 0xf4675c}, {187, 0xfa7f5e}, {200, 0xfd9869}, {216, 0xfeb67c}, {240, 0xfde2a3}, {255, 0xfcfdbf}};

constexpr Stop cividis_stops[] = {
    {0, 0x00224e},   {8, 0x00285b},   {16, 0x002e6a},  {19, 0x00306f},  {20, 0x003070},  {22, 0x003171},
    {24, 0x053371},  {26, 0x0c3470},  {28, 0x123570},  {32, 0x1a386f},  {36, 0x213b6e},  {40, 0x273e6e},
    {48, 0x32436d},  {56, 0x3b496c},  {64, 0x434e6c},  {72, 0x4b546c},  {80, 0x535a6d},  {88, 0x5a5f6e},
    {96, 0x61656f},  {104, 0x686a71}, {112, 0x6f7073}, {120, 0x767676}, {124, 0x797977}, {128, 0x7d7c78},
    {136, 0x848279}, {144, 0x8c8878}, {152, 0x938e78}, {160, 0x9b9476}, {168, 0xa39a74}, {176, 0xaba072},
    {184, 0xb4a76f}, {192, 0xbcae6c}, {200, 0xc4b468}, {208, 0xcdbb63}, {216, 0xd5c25e}, {224, 0xdec958},
    {232, 0xe7d150}, {240, 0xf0d846}, {244, 0xf5dc41}, {248, 0xf9e03a}, {251, 0xfde334}, {252, 0xfee434},
    {255, 0xfee838}};

constexpr Stop blue_red_stops[] = {
    {0, 0x3b4cc0},  {1, 0x445acc},  {2, 0x4d68d7},  {3, 0x5775e1},  {4, 0x6282ea},  {5, 0x6c8ef1},
    {6, 0x779af7},  {7, 0x82a5fb},  {8, 0x8db0fe},  {9, 0x98b9ff},  {10, 0xa3c2ff}, {11, 0xaec9fd},
    {12, 0xb8d0f9}, {13, 0xc2d5f4}, {14, 0xccd9ee}, {15, 0xd5dbe6}, {16, 0xdddddd}, {17, 0xe5d8d1},
    {18, 0xecd3c5}, {19, 0xf1ccb9}, {20, 0xf5c4ad}, {21, 0xf7bba0}, {22, 0xf7b194}, {23, 0xf7a687},
    {24, 0xf49a7b}, {25, 0xf18d6f}, {26, 0xec7f63}, {27, 0xe57058}, {28, 0xde604d}, {29, 0xd55042},
    {30, 0xcb3e38}, {31, 0xc0282f}, {32, 0xb40426}};

// Okabe and Ito's colours (2008), the order changed; some are darker than theirs, the yellow, too light on
// white, became a brown, and two violets are added. Any two differ by at least 14 in CIE Lab for every kind
// of vision.
constexpr unsigned line_colours[] = {0x0072b2, 0xd55e00, 0x009e73, 0xc9699f, 0x50ade3,
                                     0xe09800, 0x222222, 0x8f6a4a, 0x4a2fa8, 0xa56bf0};

std::span<const Stop> stops(Map map) {
    switch (map) {
        case Map::viridis:
            return viridis_stops;
        case Map::cividis:
            return cividis_stops;
        case Map::magma:
            return magma_stops;
        case Map::blue_red:
            return blue_red_stops;
    }
    return viridis_stops;
}

Colour from_hex(unsigned rgb) {
    const auto part = [rgb](unsigned shift) { return ((rgb >> shift) & 255U) / 255.0; };
    return {part(16), part(8), part(0), 1};
}

}  // namespace

Colour cycle(std::size_t index) {
    return from_hex(line_colours[index % std::size(line_colours)]);
}

Colour map_colour(Map map, double t) {
    const auto table = stops(map);
    const double index = std::clamp(t, 0.0, 1.0) * table.back().index;
    const auto above = std::find_if(table.begin() + 1, table.end() - 1,
                                    [index](const Stop& stop) { return stop.index >= index; });
    const auto below = above - 1;
    return mixed(from_hex(below->rgb), from_hex(above->rgb),
                 (index - below->index) / (above->index - below->index));
}

double map_position(double value, const std::array<double, 2>& range, Scale scale) {
    if (scale == Scale::log) return std::log(value / range[0]) / std::log(range[1] / range[0]);
    return (value - range[0]) / (range[1] - range[0]);
}

double luminance(const Colour& colour) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

Colour mixed(const Colour& a, const Colour& b, double t) {
    const auto blend = [t](double from, double to) { return from + t * (to - from); };
    return {blend(a.red, b.red), blend(a.green, b.green), blend(a.blue, b.blue), blend(a.alpha, b.alpha)};
}

Colour faded(const Colour& colour, double alpha) {
    return {colour.red, colour.green, colour.blue, alpha};
}

}  // namespace plot
