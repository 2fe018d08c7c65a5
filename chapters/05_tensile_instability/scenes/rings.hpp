#pragma once
#include "chapters/05_tensile_instability/scenes/solid.hpp"

/// Two rubber rings that fly into each other (Monaghan 2000; Gray, Monaghan & Swift 2001): radii 3 and 4, K =
/// rho = 1, so that c_0 = 1. Where they bend, one side is under tension.
namespace sph::tensile {

struct RingsScene {
    std::size_t layers = 4;  ///< of particles from the inner to the outer radius; >= 2
    double shear = 0.22;     ///< mu [K]
    double speed = 0.08;     ///< of each ring [c_0]
    double time = 180;       ///< [radius/4/c_0]
    double courant = 0.7;
    int threads = 1;
};
struct RingsRun {
    std::size_t n = 0;
    std::size_t pieces = 0, most_pieces = 0;  ///< at the end, and at most; two of them are the rings
    double rebound =
        0;  ///< speed of the left ring's centre at the end, away from the other, over that before
    double energy_left = 0, energy_gain = 0;  ///< at the end, and the most above the beginning, over that
    double momentum_drift = 0;                ///< over that of a ring
    Column t, energy;                         ///< over the beginning
    Columns<2> x;                             ///< at the end
    Counters counters;
    report::Quantities measured() const;
};
/// Throws Unstable.
RingsRun run_rings(const RingsScene& scene, const SolidMethod& method);

}  // namespace sph::tensile
