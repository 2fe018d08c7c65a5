#pragma once
#include <cstddef>

#include "common/report/race.hpp"

/// The competitor: the wave and the star on a Lagrangian grid (lagrangian_grid.hpp) with as many cells as
/// there are particles. Error and CPU seconds, by the measures of run_wave and run_nonlinear.
namespace sph::euler {

report::Lap run_grid_wave(std::size_t n);
/// One period, gamma = 2.
report::Lap run_grid_star(std::size_t n, double A_0);

}  // namespace sph::euler
