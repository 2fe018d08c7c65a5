#include "chapters/04_artificial_viscosity/figures/tubes.hpp"

namespace sph::shocks {
void blast(report::Run& run) {
    tube_figure(run,
                {.name = "blast",
                 .scene = {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006, 200},
                 .drawn = {"signal", "reconstructed"},
                 .low = 0.1,
                 .high = 0.3,
                 .block = "blast-series",
                 .sizes = {200, 400},
                 .compared = {"signal", "price", "narrow", "reconstructed"}},
                60);
}
}  // namespace sph::shocks
