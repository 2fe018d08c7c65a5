#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "common/core/arrangement.hpp"
#include "common/core/listed.hpp"
#include "common/report/prices.hpp"

/// What each listed effect costs: passes over jittered particles in the periodic unit square.
namespace sph::euler {

/// One pass with only the listed effects. h in spacings.
template <class Smoothing, class... E>
report::ListedPass listed_in_square(double h_over_dx, const Smoothing& smoothing, const E&... effects) {
    constexpr std::size_t per_side = 64;
    const double h = h_over_dx / static_cast<double>(per_side);
    const auto pass = std::make_shared<Listed<2, Box<2>, Smoothing, E...>>(
        make_points<2>(Arrangement::jittered, per_side, 0.2, 1), periodic_unit_box<2>(), h,
        smoothing.kernel.support * h, smoothing, effects...);
    return {[pass] { pass->pass(); }, pass->size(), pass->pairs(), pass->columns()};
}

/// The passes that the chapter prices, by what they list.
std::vector<std::pair<std::string, report::ListedPass>> listed_passes();

}  // namespace sph::euler
