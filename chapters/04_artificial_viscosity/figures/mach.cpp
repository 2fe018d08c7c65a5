#include "chapters/04_artificial_viscosity/figures/tubes.hpp"

namespace sph::shocks {
void mach(report::Run& run) {
    tube_figure(run,
                {.name = "mach",
                 .scene = {.right = {0.5, 0, 0.2}, .n = 120},
                 .drawn = {"signal", "reconstructed"},
                 .block = "mach-series",
                 .sizes = {120, 240, 480}},
                60);
}
}  // namespace sph::shocks
