#include "common/plot/figure.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "common/plot/colour_map.hpp"
#include "common/plot/looks.hpp"

using namespace plot;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Figure good() {
    Figure figure{"good", 1, 2};
    figure.at(0, 0).curve({1, 2, 3}, {1, 2, 3}, {.label = "curve"});
    figure.at(0, 1).log_log().curve({1, 10}, {1, 10});
    return figure;
}

struct Broken {
    const char* expected;  // part of the only line
    std::function<void(Figure&)> change;
};

}  // namespace

TEST_CASE("a figure without faults has none") {
    Figure figure = good();
    figure.at(0, 0).band({1, 2}, {1, 1}, {2, 2});
    figure.at(0, 0).particles({.x = {1, 2}, .y = {1, 2}, .value = {0, 1}});
    figure.at(0, 0).field({.x = {1, 2}, .y = {1, 2}, .value = {0, 1, 2, 3}});
    figure.at(0, 0).vectors({.x = {1}, .y = {1}, .u = {0}, .v = {0}});
    figure.at(0, 0).note(0.1, 0.9, "note").relative = true;
    figure.at(0, 1).slope(2, 1, 3, 1, "order 2");
    CHECK(faults(figure).empty());
}

TEST_CASE("each fault is found, alone, and names its place") {
    // Each row is a mutation; removing a check from faults() lets its row pass through.
    const auto broken = GENERATE(values<Broken>({
        {"name \"Bad name\"", [](Figure& f) { f.name = "Bad name"; }},
        {"1 panels do not fill", [](Figure& f) { f.panels.pop_back(); }},
        {"panel (a): curve \"curve\": y has 2 values instead of 3",
         [](Figure& f) { f.at(0, 0).curves[0].y.pop_back(); }},
        {"panel (a): curve \"curve\": y[1] = nan is not finite",
         [](Figure& f) { f.at(0, 0).curves[0].y[1] = nan_value; }},
        {"x[0] = inf is not finite",
         [](Figure& f) { f.at(0, 0).curves[0].x[0] = std::numeric_limits<double>::infinity(); }},
        {"error has 1 values", [](Figure& f) { f.at(0, 0).curves[0].error = {1}; }},
        {"error is negative",
         [](Figure& f) {
             f.at(0, 0).curves[0].error = {1, -1, 1};
         }},
        {"no points", [](Figure& f) { f.at(0, 0).curve({}, {}); }},
        {"neither line nor markers", [](Figure& f) { f.at(0, 0).curves[0].style.width = 0; }},
        {"panel (b): curve 1: y[0] = 0 is not positive", [](Figure& f) { f.at(0, 1).curves[0].y[0] = 0; }},
        {"panel (b): x range 10..1 is reversed", [](Figure& f) { f.at(0, 1).x_range(10, 1); }},
        {"y range[0] = -1 is not positive", [](Figure& f) { f.at(0, 1).y_range(-1, 1); }},
        {"too narrow", [](Figure& f) { f.at(0, 0).x_range(1, 1 + 1e-14); }},
        {"panel (a): no data inside the axes", [](Figure& f) { f.at(0, 0).x_range(100, 200); }},
        {"note \"far\" lies outside", [](Figure& f) { f.at(0, 0).x_range(0, 3).note(5, 1, "far"); }},
        {"value has 3 values instead of 4",
         [](Figure& f) {
             f.at(0, 0).field({.x = {1, 2}, .y = {1, 2}, .value = {0, 1, 2}});
         }},
        {"x and y must increase",
         [](Figure& f) {
             f.at(0, 0).field({.x = {2, 1}, .y = {1, 2}, .value = {0, 1, 2, 3}});
         }},
        {"value[0] = 0 is not positive",
         [](Figure& f) {
             f.at(0, 0).particles({.x = {1}, .y = {1}, .value = {0}, .bar = {.scale = Scale::log}});
         }},
        {"u has 0 values", [](Figure& f) { f.at(0, 0).vectors({.x = {1}, .y = {1}, .v = {1}}); }},
        {"band 1: low has 1 values",
         [](Figure& f) {
             f.at(0, 0).band({1, 2}, {1}, {1, 2});
         }},
        {"slope \"2\": needs a log-log panel", [](Figure& f) { f.at(0, 0).slope(2, 1, 2, 1, "2"); }},
        {"tick names", [](Figure& f) { f.at(0, 0).x.tick_names = {"a"}; }},
        {"equal_aspect needs linear axes", [](Figure& f) { f.at(0, 1).equal_aspect = true; }},
        {"at least 100 points", [](Figure& f) { f.panel_width = 20; }},
    }));
    Figure figure = good();
    broken.change(figure);
    const auto found = faults(figure);
    CAPTURE(broken.expected, found);
    REQUIRE(found.size() == 1);
    CHECK(found[0].find(broken.expected) != std::string::npos);
}

TEST_CASE("references that the builders return stay valid") {
    Figure figure{"builders"};
    auto& panel = figure.panel().titled("title").labels("x", "y").log_y();
    Curve& first = panel.curve({1, 2}, {3, 4});
    for (int k = 0; k < 1000; ++k) panel.points({1}, {2});
    // Fails with vectors in place of deques (under the address sanitizer at the latest).
    first.style.label = "first";
    CHECK(panel.curves.front().style.label == "first");
    CHECK(panel.curves.back().style.width == 0);
    CHECK(panel.curves.back().style.marker == Marker::circle);
    CHECK(panel.y.scale == Scale::log);
    CHECK(panel.x.scale == Scale::linear);
    const ReferenceSlope& slope = panel.slope(2, 1, 10, 5, "order 2");
    CHECK(slope.order == 2);
    CHECK(slope.x1 == 10);
    CHECK(slope.y0 == 5);
    CHECK_THROWS_AS(figure.at(0, 1), std::out_of_range);
    CHECK_THROWS_AS(Figure("none", 0, 1), std::invalid_argument);
}

TEST_CASE("colour maps pass through entries of the published tables") {
    const auto differs = [](Map map, double t, unsigned rgb) {
        const Colour c = map_colour(map, t);
        const double parts[3] = {c.red, c.green, c.blue};
        double worst = 0;
        for (unsigned k = 0; k < 3; ++k)
            worst = std::max(worst, std::abs(255 * parts[k] - ((rgb >> (16 - 8 * k)) & 255U)));
        return worst;
    };
    // Entries that are not among the stops; within 1.5/255. Fails if a stop's index or digits are wrong
    // nearby.
    CHECK(differs(Map::viridis, 64 / 255.0, 0x3b528b) < 1.5);
    CHECK(differs(Map::viridis, 100 / 255.0, 0x2b758e) < 1.5);
    CHECK(differs(Map::viridis, 224 / 255.0, 0xaddc30) < 1.5);
    CHECK(differs(Map::magma, 96 / 255.0, 0x82257f) < 2.5);
    CHECK(differs(Map::cividis, 60 / 255.0, 0x3f4c6c) < 1.5);
    CHECK(differs(Map::cividis, 220 / 255.0, 0xdac65a) < 1.5);
    CHECK(differs(Map::blue_red, 0.5, 0xdddddd) < 1);
    // Clamped outside; NaN-free at the ends.
    CHECK(differs(Map::viridis, -3, 0x440154) < 0.5);
    CHECK(differs(Map::viridis, 7, 0xfde725) < 0.5);
}

TEST_CASE("sequential maps grow lighter all the way, the diverging one is lightest in its middle") {
    for (const Map map : {Map::viridis, Map::cividis, Map::magma})
        for (int k = 0; k < 255; ++k)  // fails if two stops are exchanged
            CHECK(luminance(map_colour(map, (k + 1) / 255.0)) > luminance(map_colour(map, k / 255.0)) - 1e-3);
    for (int k = 0; k < 127; ++k) {
        CHECK(luminance(map_colour(Map::blue_red, (k + 1) / 255.0)) >
              luminance(map_colour(Map::blue_red, k / 255.0)));
        CHECK(luminance(map_colour(Map::blue_red, 1 - (k + 1) / 255.0)) >
              luminance(map_colour(Map::blue_red, 1 - k / 255.0)));
    }
}

TEST_CASE("the cycle has ten colours that read on white") {
    for (std::size_t a = 0; a < 10; ++a) {
        const double contrast = 1.05 / (luminance(cycle(a)) + 0.05);
        CHECK(contrast >
              2.2);  // the lightest, orange and sky blue: 2.4; fails with Okabe and Ito's yellow: 1.3
        for (std::size_t b = 0; b < a; ++b)
            CHECK(std::abs(cycle(a).red - cycle(b).red) + std::abs(cycle(a).green - cycle(b).green) +
                      std::abs(cycle(a).blue - cycle(b).blue) >
                  0.25);
    }
    CHECK(cycle(10).green == cycle(0).green);
}

TEST_CASE("horizontal bars stand under each other, named, the first on top") {
    // Fails if the order is turned, if a bar does not begin at zero, or if a given range is overridden.
    Figure figure{"bars"};
    Panel& panel = figure.panel().bars({"fast", "slow", "none"}, {2, 8, 0});
    CHECK(panel.y.ticks == Values{3, 2, 1});
    CHECK(panel.y.tick_names == std::vector<std::string>{"fast", "slow", "none"});
    REQUIRE(panel.bands.size() == 3);
    CHECK(panel.bands[1].x == Values{0, 8});
    CHECK(panel.bands[1].low[0] < 2);
    CHECK(panel.bands[1].high[0] > 2);
    CHECK(panel.bands[1].low[0] > panel.bands[2].high[0]);  // they do not touch
    CHECK((*panel.x.range)[0] == 0);
    CHECK((*panel.x.range)[1] == Approx(8.8));
    CHECK_FALSE(panel.grid);
    CHECK(faults(figure).empty());
    Figure ranged{"bars"};
    ranged.panel().x_range(0, 105).bars({"a"}, {50});
    CHECK((*ranged.panel().x.range)[1] == 105);
    CHECK_THROWS_AS(ranged.panel().bars({"a", "b"}, {1}), std::invalid_argument);
}

TEST_CASE("what looks the same in every figure") {
    // Fails if a competitor has a colour, or if dots keep their line.
    CHECK(exact().label == "exact");
    CHECK(exact().marker == Marker::none);
    const Style grid = competitor("grid", Marker::plus);
    for (const Style& style : {exact(), grid}) {
        REQUIRE(style.colour.has_value());
        CHECK(style.colour->red + style.colour->green + style.colour->blue == 0);
    }
    CHECK(grid.label == "grid");
    CHECK(grid.marker == Marker::plus);
    CHECK(competitor("grid").marker == Marker::cross);
    CHECK(dots(grid).width == 0);
    CHECK(dots(grid, 2).marker_size == 2);
    CHECK(dots(grid).marker == Marker::plus);
    CHECK(line(grid).marker == Marker::none);
    CHECK(line(grid).width == grid.width);
}
