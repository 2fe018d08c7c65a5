#pragma once
#include "chapters/09_transverse_expansion/scenes/flow.hpp"
#include "common/core/particles.hpp"

/// The competitor: finite volumes on rings around the axis. It is given the symmetry that particles are not.
namespace sph::transverse {

struct RingsRun {
    Column r, temperature;
    double l1_temperature = 0;  ///< by area, r < R: the measure of Snapshot
    double seconds = 0;         ///< CPU time of the steps
    long steps = 0;
};
/// The cylinder of c0^2 = 1/3 on n rings of 0 <= r <= R + tau - tau0 at the end, which move outwards so that
/// no ring is without fluid for long.
RingsRun run_rings(const Flow& flow, std::size_t n, double tau);

}  // namespace sph::transverse
