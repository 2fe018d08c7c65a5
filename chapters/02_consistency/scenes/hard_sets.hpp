#pragma once
#include <string>
#include <vector>

#include "chapters/02_consistency/repair.hpp"

/// Neighbours that do not determine a slope: what the naive and the guarded correction make of them.
namespace sph::consistency {

/// Offsets of the neighbours from a particle at the origin of the plane, in units of h = 1.
struct HardSet {
    std::string name;
    std::vector<Vector<2>> neighbours;
};
/// One neighbour, neighbours on a line, in one place, none.
std::vector<HardSet> hard_sets();
/// Six neighbours along a slanted line, alternately shifted across it by half of `width`.
HardSet band(double width);

/// Slopes at the particle of A = x + y + x^2 - y^2 + x y, which is (1, 1), with the quintic spline.
struct HardSlopes {
    Vector<2> exact{1.0, 1.0}, naive{}, naive_linear{}, guarded{}, guarded_linear{};
};
HardSlopes hard_slopes(const HardSet& set);

/// n x n random particles of the unit square, cubic spline, h = 0.8 dx, eight neighbours in the mean and
/// often fewer: the largest error of CSPM's slope over the largest slope of chapter 1's function.
struct RandomPlane {
    double naive = 0, guarded = 0, repaired = 0;  ///< naive: infinite if one of its slopes is meaningless
    /// Particles whose neighbours lie on a line (one neighbour, or none): the naive slope is not a number, or
    /// noise.
    std::size_t singular = 0;
    Repairs repairs;
};
RandomPlane random_plane(std::size_t n, std::uint64_t seed);

}  // namespace sph::consistency
