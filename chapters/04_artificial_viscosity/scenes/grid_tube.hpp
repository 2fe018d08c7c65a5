#pragma once
#include "chapters/04_artificial_viscosity/scenes/woodward_colella.hpp"
#include "common/exact/finite_volume.hpp"

/// The competitor: the same scenes on a finite-volume grid, with as many cells in |x| < 0.5 as there are
/// particles.
namespace sph::shocks {

/// Eulerian: cells of one width. Lagrangian: of one mass, as the particles. Both states must be gas.
TubeRun run_grid_tube(const TubeScene& scene, exact::Frame frame);
TubeRun run_grid_blast_waves(const BlastWaves& scene, exact::Frame frame);
/// What run_standing_wave measures, on n cells: its error and CPU seconds.
struct GridWave {
    double error, seconds;
};
GridWave grid_standing_wave(std::size_t n, exact::Frame frame = exact::Frame::eulerian);

/// Both grids, as figures name and draw them.
struct Grid {
    std::string name, label;
    exact::Frame frame;
    plot::Style look;
};
const std::vector<Grid>& grids();

}  // namespace sph::shocks
