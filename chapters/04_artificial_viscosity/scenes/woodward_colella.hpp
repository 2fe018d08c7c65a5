#pragma once
#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

/// Two blast waves between walls, which meet (Woodward & Colella 1984): rho = 1, gamma = 1.4, P = 1000, 0.01
/// and 100 in [0, 0.1], [0.1, 0.9] and [0.9, 1], until t = 0.038. No exact solution is known.
namespace sph::shocks {

struct BlastWaves {
    std::size_t n = 400;
    double jitter = 0;
    unsigned long seed = 1;
    double courant = 0.45;
    int threads = 1;
    long most_steps = std::numeric_limits<long>::max();  ///< a run that needs more is stopped as unstable
};
double blast_waves_pressure(double x);

/// Errors against exact::WoodwardColella over all of [0, 1]. Throws Unstable, also for particles that
/// overtake each other.
TubeRun run_blast_waves(const BlastWaves& scene, const Method<1>& method);

/// Fills the reference beside run.whole, and the errors; dx are the widths of its points.
void compare_blast_waves(TubeRun& run, const Column& dx);

}  // namespace sph::shocks
