#pragma once
#include "chapters/04_artificial_viscosity/scenes/woodward_colella.hpp"
#include "common/exact/finite_volume.hpp"

/// The competitor: the same scenes on a finite-volume grid, with as many cells in |x| < 0.5 as there are
/// particles.
namespace sph {

/// Eulerian: cells of one width. Lagrangian: of one mass, as the particles. Both states must be gas.
TubeRun run_grid_tube(const TubeScene& scene, exact::Frame frame);
TubeRun run_grid_blast_waves(const BlastWaves& scene, exact::Frame frame);
/// The error of run_standing_wave, on n cells.
double grid_standing_wave_error(std::size_t n, exact::Frame frame = exact::Frame::eulerian);

}  // namespace sph
