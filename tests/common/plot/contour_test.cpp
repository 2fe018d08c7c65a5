#include "common/plot/contour.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace plot;

namespace {

/// f on [-1, 1]^2, n points each way.
template <class Function>
Field field_of(std::size_t n, Function f) {
    Field field;
    for (std::size_t k = 0; k < n; ++k)
        field.x.push_back(2.0 * static_cast<double>(k) / static_cast<double>(n - 1) - 1);
    field.y = field.x;
    for (const double y : field.y)
        for (const double x : field.x) field.value.push_back(f(x, y));
    return field;
}

double length(const Polyline& line) {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k)
        sum += std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
    return sum;
}

double area(const Polyline& line) {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k)
        sum += line[k - 1].x * line[k].y - line[k].x * line[k - 1].y;
    return std::abs(sum) / 2;
}

bool closed(const Polyline& line) {
    return std::hypot(line.front().x - line.back().x, line.front().y - line.back().y) < 1e-14;
}

}  // namespace

TEST_CASE("the contour of a distance is one closed circle") {
    const double r = 0.6;
    // Linear interpolation errs by h^2/(8 r) in the radius, h = 2/(n - 1): 8.3e-4 and 2.1e-4 of r^2 at most;
    // measured area errors 2.6e-4 and 6.5e-5. Fails without interpolation (crossings at mid-edge) and if
    // segments are not joined (many lines).
    double errors[2];
    const std::size_t sizes[2] = {41, 81};
    for (int k = 0; k < 2; ++k) {
        const auto lines =
            contour_lines(field_of(sizes[k], [](double x, double y) { return std::hypot(x, y); }), r);
        REQUIRE(lines.size() == 1);
        CHECK(closed(lines[0]));
        errors[k] = std::abs(area(lines[0]) / (std::numbers::pi * r * r) - 1);
        CHECK(length(lines[0]) == Approx(2 * std::numbers::pi * r).epsilon(2e-3));
    }
    CHECK(errors[0] < 2e-3);
    CHECK(std::log2(errors[0] / errors[1]) > 1.6);
    CHECK(std::log2(errors[0] / errors[1]) < 2.4);
}

TEST_CASE("the contour of a plane is one straight line from edge to edge") {
    // x + y = 0.3 cuts [-1, 1]^2 between (-0.7, 1) and (1, -0.7). Fails if the walk begins in its middle.
    const auto lines = contour_lines(field_of(20, [](double x, double y) { return x + y; }), 0.3);
    REQUIRE(lines.size() == 1);
    CHECK(length(lines[0]) == Approx(1.7 * std::numbers::sqrt2).epsilon(1e-12));
    for (const auto& [x, y] : lines[0]) CHECK(x + y == Approx(0.3).margin(1e-14));
}

TEST_CASE("a saddle, a level on grid values and a level outside give whole lines") {
    const auto saddle = field_of(11, [](double x, double y) { return x * y; });
    // Fails if a value equal to the level were on both sides: lines would break at grid nodes.
    for (const double level : {0.0, 0.04, -0.04})
        for (const auto& line : contour_lines(saddle, level)) CHECK((closed(line) || line.size() > 10));
    CHECK(contour_lines(saddle, 0.04).size() == 2);
    CHECK(contour_lines(saddle, 7).empty());
    CHECK(contour_lines(field_of(5, [](double, double) { return 1.0; }), 1).empty());
}
