#include <cmath>

#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"

namespace sph::shocks {

void sod_without(report::Run& run) {
    const Entropies found = follow_entropy(run, "none", "sod-without");
    run.claim("nothing-heats", [&] { return found.largest_gain < 0.03 * found.due && found.noise > 0.5; });
}

}  // namespace sph::shocks
