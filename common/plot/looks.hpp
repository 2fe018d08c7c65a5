#pragma once
#include <string>

#include "common/plot/figure.hpp"

/// What looks the same in every figure of the book.
namespace plot {

inline constexpr Colour black{0, 0, 0};

/// The exact solution: a thin black line over everything else.
inline Style exact(std::string label = "exact") {
    return {.label = std::move(label), .colour = black, .width = 1, .layer = 2};
}
/// The competitor that a chapter measures itself against, mostly a grid.
inline Style competitor(std::string label, Marker marker = Marker::cross) {
    return {.label = std::move(label), .colour = black, .marker = marker};
}
/// A look without its line: for particles.
inline Style dots(Style look, double size = 3.5) {
    look.width = 0;
    look.marker_size = size;
    return look;
}
/// A look without its markers: for a dense line.
inline Style line(Style look) {
    look.marker = Marker::none;
    return look;
}

/// The exact solution f as a line over [low, high].
template <class F>
Curve& draw_exact(Panel& panel, double low, double high, F&& f, const Style& look = exact()) {
    constexpr int points = 201;
    Values x, y;
    for (int k = 0; k < points; ++k) {
        x.push_back(low + (high - low) * k / (points - 1));
        y.push_back(f(x.back()));
    }
    return panel.curve(x, y, look);
}

/// Particles as markers beside the exact solution as a line.
inline Panel& beside_exact(Panel& panel, const Values& line_x, const Values& line, const Values& x,
                           const Values& value, double size = 3) {
    panel.curve(line_x, line, exact());
    panel.points(x, value, {.label = "SPH", .marker = Marker::circle, .marker_size = size});
    return panel;
}

}  // namespace plot
