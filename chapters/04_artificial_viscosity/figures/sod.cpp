#include "chapters/04_artificial_viscosity/figures/tubes.hpp"

namespace sph::shocks {
void sod(report::Run& run) {
    tube_figure(run,
                {.name = "sod",
                 .scene = {},
                 .drawn = {"thermokinetic", "reconstructed"},
                 .block = "sod-series",
                 .sizes = {180, 360, 720, 900}},
                90);
}
}  // namespace sph::shocks
