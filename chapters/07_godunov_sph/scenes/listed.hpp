#pragma once
#include "chapters/03_euler_sph/scenes/listed.hpp"

namespace sph::godunov {

/// The passes that the chapter prices, by what they list.
std::vector<std::pair<std::string, report::ListedPass>> listed_passes();

}  // namespace sph::godunov
