#pragma once
#include <map>
#include <string>
#include <vector>

#include "chapters/05_tensile_instability/scenes/cure.hpp"

/// What the figures of the cures share.
namespace sph::tensile {

/// All figures of merit of a method: those of the lattice, and of disorder the worst of the seeds.
struct Merits {
    double growth = 0, sound_speed = 0, shear_speed = 0;
    CureRun run;  ///< of the first seed, with the worst of all in its numbers

    report::Quantities measured() const;
    /// The four demands: growth below 1e-3 c/dx, sound within 3 % of c, momentum exact to rounding, and
    /// particles in order.
    bool holds() const;
};
Merits merits_of(const CureMethod& method, const CureScene& scene, const std::vector<std::uint64_t>& seeds);

/// The scene of the figures: short and small in a quick run.
CureScene cure_scene(const report::Run& run);
std::vector<std::uint64_t> cure_seeds(const report::Run& run);

}  // namespace sph::tensile
