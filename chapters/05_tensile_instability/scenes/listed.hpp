#pragma once
#include "chapters/03_euler_sph/scenes/listed.hpp"

namespace sph::tensile {

/// The passes that the chapter prices, by what they list: those of its liquids and solids, and their parts.
std::vector<std::pair<std::string, report::ListedPass>> listed_passes();

}  // namespace sph::tensile
