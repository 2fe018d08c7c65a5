#pragma once
#include "chapters/04_artificial_viscosity/scenes/plane_methods.hpp"
#include "chapters/04_artificial_viscosity/figures/figures.hpp"

namespace sph::shocks {

/// style_of(), for methods in the plane too.
inline plot::Style plane_style(const std::string& name) {
    plot::Style style = style_of(name);
    style.label = plane_method(name).label;
    if (name == "signal") style.colour = plot::cycle(5);
    if (name == "balsara") style.colour = plot::cycle(2), style.marker = plot::Marker::triangle_up;
    if (name == "colagrossi") style.colour = plot::cycle(3), style.marker = plot::Marker::diamond;
    if (name == "pairwise") style.colour = plot::cycle(0), style.marker = plot::Marker::circle;
    if (name == "stress") style.colour = plot::cycle(1), style.marker = plot::Marker::square;
    if (name == "none-cubic") style.colour = plot::cycle(6), style.dash = plot::Dash::dashed;
    return style;
}
inline plot::Style grid_style() {
    return {.label = "grid", .colour = plot::Colour{0.35, 0.35, 0.35}, .marker = plot::Marker::cross};
}

}  // namespace sph::shocks
