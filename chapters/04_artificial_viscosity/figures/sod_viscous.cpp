#include <cmath>

#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"

namespace sph::shocks {

void sod_viscous(report::Run& run) {
    const Entropies found = follow_entropy(run, "alpha-beta", "sod-viscous");
    run.fill("entropy-gained", report::number(100 * found.gain, 2));
    run.claim("viscosity-heats",
              [&] { return std::abs(found.gain / found.due - 1) < 0.1 && found.noise < 0.002; });
}

}  // namespace sph::shocks
