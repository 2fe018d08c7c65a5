#pragma once
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"

namespace sph::godunov {

/// Those of line_methods() that keep the paper's Gaussian, in their order.
std::vector<Method<1>> gaussian_methods();

}  // namespace sph::godunov
