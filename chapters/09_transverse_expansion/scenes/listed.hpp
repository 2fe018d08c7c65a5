#pragma once
#include <string>
#include <utility>
#include <vector>

#include "common/report/prices.hpp"

namespace sph::transverse {

/// The passes that the chapter prices, by what they list.
std::vector<std::pair<std::string, report::ListedPass>> listed_passes();

}  // namespace sph::transverse
