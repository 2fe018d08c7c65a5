#pragma once
#include <string>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/02_consistency/scenes/measured.hpp"
#include "common/plot/method_looks.hpp"

/// What several figures share.
namespace sph::consistency {

using interpolation::kernel_label;
using interpolation::linear_space;
using interpolation::log_space;

/// How a scheme is drawn, the same in every figure.
template <int d>
plot::Style scheme_style(const Scheme<d>& scheme) {
    return plot::look_of(scheme.name, scheme.label);
}

}  // namespace sph::consistency
