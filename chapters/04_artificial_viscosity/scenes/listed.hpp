#pragma once
#include "chapters/03_euler_sph/scenes/listed.hpp"

namespace sph::shocks {

/// The passes that the chapter prices, by what they list: those that its gases run, and their parts.
std::vector<std::pair<std::string, report::ListedPass>> listed_passes();

}  // namespace sph::shocks
