#include <algorithm>

#include "chapters/08_landau_model/figures/slab_profiles.hpp"

namespace sph::landau {
void early(report::Run& run) {
    const auto profiles = slab_profiles(run, "early", {0.25, 0.5, 1, 1.5});
    run.claim("early-error", [&] {
        return std::all_of(profiles.begin(), profiles.end(),
                           [](const SlabProfile& one) { return one.l1_s_star < 2.5e-4; });
    });
}
}  // namespace sph::landau
