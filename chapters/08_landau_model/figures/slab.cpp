#include "chapters/08_landau_model/figures/slab_profiles.hpp"

namespace sph::landau {
void slab(report::Run& run) {
    const double error = slab_profiles(run, "slab", {2, 4, 6, 8, 10});
    run.fill("answer-slab", report::number(error, 2));
}
}  // namespace sph::landau
