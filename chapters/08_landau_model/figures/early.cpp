#include "chapters/08_landau_model/figures/slab_profiles.hpp"

namespace sph::landau {
void early(report::Run& run) {
    slab_profiles(run, "early", {0.25, 0.5, 1, 1.5});
}
}  // namespace sph::landau
