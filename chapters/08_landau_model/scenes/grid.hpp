#pragma once
#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"
#include "chapters/08_landau_model/scenes/slab.hpp"

/// The honest competitor: the same scenes on a relativistic finite-volume grid of second order
/// (common/exact/relativistic_finite_volume.hpp).
namespace sph::landau {

/// The right half of the slab in `n` cells that expand with it; profiles of both halves. `counters.pairs` are
/// updates of cells.
std::vector<SlabProfile> run_grid_slab(std::size_t n, const std::vector<double>& times);
/// The tube with `scene.n` cells in |x| < 0.5. Vacuum is not for this grid.
TubeRun run_grid_relativistic_tube(const TubeScene& scene);

}  // namespace sph::landau
