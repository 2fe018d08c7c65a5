#pragma once
#include <array>
#include <string>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/02_consistency/scenes/measured.hpp"

/// What several figures share.
namespace sph::consistency {

using interpolation::kernel_label;
using interpolation::linear_space;
using interpolation::log_space;

/// How a scheme is drawn, the same in every figure: by its place in schemes<2>().
template <int d>
plot::Style scheme_style(const Scheme<d>& scheme) {
    const auto all = schemes<2>();
    std::size_t index = 0;
    while (index + 1 < all.size() && all[index].name != scheme.name) ++index;
    using plot::Marker;
    constexpr std::array shapes{Marker::square, Marker::triangle_up, Marker::plus,
                                Marker::circle, Marker::diamond,     Marker::triangle_down};
    return {.label = scheme.label, .colour = plot::cycle(index), .marker = shapes.at(index)};
}

}  // namespace sph::consistency
