#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "common/plot/canvas.hpp"
#include "tests/common/plot/picture.hpp"

using picture::black;
using picture::drawn;
using picture::ink_at;
using picture::on_circle;
using plot::Canvas;
using plot::Image;
using plot::Point;
using plot::Polyline;

namespace {

Image stroke(Canvas& canvas, const Polyline& line, double width, std::span<const double> dashes = {}) {
    return drawn(canvas, 120, 120, [&](Canvas& c) { c.stroke({&line, 1}, width, black, dashes); });
}

/// Part of the pixel (x, y) that is nearer than half_width to the segment, from 32 x 32 samples.
double exact_coverage(int x, int y, const Point& a, const Point& b, double half_width) {
    constexpr int n = 32;
    int inside = 0;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point way{(b.x - a.x) / length, (b.y - a.y) / length};
    for (int i = 0; i < n * n; ++i) {
        const int row = i / n;
        const Point p{x + (i % n + 0.5) / n - a.x, y + (row + 0.5) / n - a.y};
        const double along = std::clamp(p.x * way.x + p.y * way.y, 0.0, length);
        if (std::hypot(p.x - along * way.x, p.y - along * way.y) < half_width) ++inside;
    }
    return static_cast<double>(inside) / (n * n);
}

}  // namespace

TEST_CASE("a line covers its length times its width, at any angle") {
    Canvas canvas;
    for (const double width : {0.5, 1.0, 1.5, 3.0, 8.0})
        for (const double angle : {0.0, 11.0, 27.0, 45.0, 63.5, 90.0, 137.0}) {
            CAPTURE(width, angle);
            const Point centre{60.3, 59.8};
            const auto ink = picture::ink(
                stroke(canvas, {on_circle(centre, 40, angle), on_circle(centre, -40, angle)}, width));
            const double area = 80 * width + std::numbers::pi * width * width / 4;  // with its round caps
            // Measured: 0.9 % at 0.5 pixels' width (the caps of thin lines), 0.2 pixels between centres
            // (along the line, from the caps). Fails if lines are 0.1 pixels too wide, or have no caps.
            CHECK(ink.sum == Approx(area).epsilon(0.012));
            CHECK(ink.x == Approx(centre.x).margin(0.25));
            CHECK(ink.y == Approx(centre.y).margin(0.25));
        }
}

TEST_CASE("a line's pixels are as dark as the part of them that it covers") {
    Canvas canvas;
    double squares = 0;
    int pixels = 0;
    for (double angle = 3; angle < 180; angle += 13) {
        const Point a = on_circle({60.3, 59.8}, 45, angle), b = on_circle({60.3, 59.8}, -45, angle);
        const Image image = stroke(canvas, {a, b}, 1.5);
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 120; ++x) {
                const double exact = exact_coverage(x, y, a, b, 0.75);
                if (exact == 0 && ink_at(image, x, y) == 0) continue;
                squares += std::pow(ink_at(image, x, y) - exact, 2);
                ++pixels;
            }
    }
    // RMS in steps of 255. Measured: 2.1, from the caps; fails (4.6) with a linear ramp across the edge.
    CHECK(255 * std::sqrt(squares / pixels) < 3);
}

TEST_CASE("a line of short pieces looks like one segment") {
    Canvas canvas;
    const Point a{10.2, 15.7}, b{108.6, 73.1};
    Polyline pieces;
    const int count = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / 0.3);
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        pieces.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    const Image one = stroke(canvas, {a, b}, 1.5), many = stroke(canvas, pieces, 1.5);
    // Measured: 4 and 0.2 %, from the caps of the pieces; fails (> 100) if pieces add up.
    CHECK(picture::largest_difference(one, many) <= 6);
    CHECK(picture::ink(many).sum == Approx(picture::ink(one).sum).epsilon(4e-3));
}

TEST_CASE("a translucent stroke that crosses itself does not add up") {
    Canvas canvas;
    const Polyline loop{{20, 20}, {100, 100}, {100, 20}, {20, 100}};
    const Image image = drawn(canvas, 120, 120, [&](Canvas& c) { c.stroke({&loop, 1}, 6, {0, 0, 0, 0.5}); });
    // Fails (0.75) if segments are blended one by one, at the crossing and at the joints.
    CHECK(ink_at(image, 60, 60) == Approx(0.5).margin(0.003));
    CHECK(ink_at(image, 99, 99) == Approx(0.5).margin(0.003));
    CHECK(ink_at(image, 40, 40) == Approx(0.5).margin(0.003));
}

TEST_CASE("a line far longer than the picture is the same as its visible part") {
    Canvas canvas;
    const Image far = stroke(canvas, {{-1e12, -1e12}, {1e12, 1e12}}, 3);
    const Image near = stroke(canvas, {{-50, -50}, {200, 200}}, 3);
    CHECK(picture::largest_difference(far, near) <= 1);  // fails if it is not cut before it becomes float
    // Fails (by 2 pixels' worth of cap and more) if it is cut inside the picture.
    CHECK(picture::ink(stroke(canvas, {{-1e6, 60.5}, {1e6, 60.5}}, 3)).sum == Approx(360).margin(0.5));
    const std::array<double, 2> dashes{8, 4};
    const auto dashed = picture::ink(stroke(canvas, {{-1e9, 60}, {1e9, 60}}, 1, dashes));
    CHECK(dashed.sum == Approx(120 * 8 / 12.0).margin(4));  // and ends soon: 1e8 dashes are not gone through
}

TEST_CASE("points that are not finite leave gaps, points alone are dots") {
    Canvas canvas;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const Image image =
        stroke(canvas, {{10, 20}, {40, 20}, {nan, 20}, {70, 20}, {inf, 3}, {90, 20}, {100, 20}}, 4);
    CHECK(ink_at(image, 25, 20) == 1);
    CHECK(ink_at(image, 55, 20) == 0);  // fails if the gap is bridged
    CHECK(ink_at(image, 70, 20) == 1);  // fails if a point alone is dropped
    CHECK(ink_at(image, 80, 20) == 0);
    CHECK(ink_at(image, 95, 20) == 1);
    CHECK(picture::ink(stroke(canvas, {{nan, nan}}, 4)).sum == 0);
    CHECK(picture::ink(stroke(canvas, {}, 4)).sum == 0);
    CHECK(picture::ink(stroke(canvas, {{5, 5}, {50, 50}}, 0)).sum == 0);
    CHECK(picture::ink(stroke(canvas, {{5, 5}, {50, 50}}, nan)).sum == 0);
}

TEST_CASE("dashes have their length, caps included, and go on around corners") {
    Canvas canvas;
    const std::array<double, 2> dashes{12, 8};
    const Image straight = stroke(canvas, {{10, 50}, {110, 50}}, 4, dashes);
    const double dash = 8 * 4 + std::numbers::pi * 4;  // 12 long, round ends of radius 2
    CHECK(picture::ink(straight).sum == Approx(5 * dash).epsilon(0.01));
    CHECK(ink_at(straight, 10, 49) > 0.5);
    CHECK(ink_at(straight, 15, 49) == 1);
    CHECK(ink_at(straight, 22, 49) < 0.01);  // fails if caps grow into the gap
    CHECK(ink_at(straight, 26, 49) == 0);
    Polyline bent;
    for (int i = 0; i <= 500; ++i) bent.push_back({10 + 0.2 * i, 50});
    // Fails if each piece begins its dashes anew.
    CHECK(picture::largest_difference(straight, stroke(canvas, bent, 4, dashes)) <= 2);
    const std::array<double, 2> dots{0, 10};
    CHECK(picture::ink(stroke(canvas, {{15, 50}, {104, 50}}, 4, dots)).sum ==
          Approx(9 * std::numbers::pi * 4).epsilon(0.03));  // measured: 2 %
    for (const std::vector<double>& wrong : {std::vector<double>{5}, {5, -1}, {5, NAN}, {0, 0}})
        CHECK_THROWS_AS(stroke(canvas, {{1, 1}, {9, 9}}, 1, wrong), std::invalid_argument);
}

TEST_CASE("rules are sharp: whole pixels, black or white") {
    Canvas canvas;
    for (const double at : {20.0, 20.3, 20.5, 20.9})
        for (const double width : {0.4, 1.0, 1.6, 2.0, 3.0}) {
            CAPTURE(at, width);
            const Image image = drawn(canvas, 60, 60, [&](Canvas& c) {
                c.rule({5.2, at}, {55.1, at}, width, black);
            });
            const double thick = std::max(1.0, std::round(width));
            CHECK(picture::ink(image).sum == 50 * thick);
            const auto ink = picture::ink(image, 0);
            CHECK((ink.bottom - ink.top + 1) == thick);  // fails if edges are not snapped
            CHECK(ink.y == Approx(at).margin(0.5));
            const Image turned = drawn(canvas, 60, 60, [&](Canvas& c) {
                c.rule({at, 55.1}, {at, 5.2}, width, black);
            });
            CHECK(picture::ink(turned).x == ink.y);  // fails if one direction is rounded otherwise
        }
}

TEST_CASE("rectangles side by side leave no seam and do not overlap") {
    Canvas canvas;
    const Image image = drawn(canvas, 200, 10, [](Canvas& c) {
        for (int i = 0; i < 37; ++i) c.rectangle({5 + 5.13 * i, 0, 5 + 5.13 * (i + 1), 10}, {0, 0, 0, 0.5});
    });
    int wrong = 0;
    for (int x = 5; x < 194; ++x)
        if (std::abs(ink_at(image, x, 5) - 0.5) > 0.003) ++wrong;
    CHECK(wrong == 0);  // fails (a column a bar) if left and right edges are rounded differently
}
