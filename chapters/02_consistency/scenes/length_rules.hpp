#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/core/neighbour_list.hpp"
#include "common/core/vec.hpp"

/// Smoothing lengths that follow the particles of a line whose density rises tenfold (graded_line.hpp).
namespace sph::consistency {

/// What a rule makes of the line, away from its ends: errors of density and of chapter 1's function, and
/// forces.
struct GradedRun {
    Column x, rho_error, h;
    double l2_rho = 0, l2_value = 0;
    double net_force = 0;   ///< |sum of the forces on all particles| over the sum of their sizes
    double neighbours = 0;  ///< a particle
};

/// A rule for h, and for how the two h of a pair become one kernel. Quintic spline, h/dx = 1.2.
struct LengthRule {
    std::string name, label, plain;  // in results, in figures, in tables
    std::function<GradedRun(std::size_t n)> run;
};
const std::vector<LengthRule>& length_rules();

/// The mean of both kernels (61), for pairs that are found in this way: gathered, some see each other on one
/// side only.
GradedRun run_mean_kernel(std::size_t n, Support support);

}  // namespace sph::consistency
