#pragma once
#include <optional>

#include "chapters/04_artificial_viscosity/scenes/methods.hpp"

/// The recommended method taken apart: its viscosity, its kernel and its conduction, each with and without
/// the others, so that what each of them does can be said.
namespace sph::shocks {

/// What a combination has of the recommended method.
struct Parts {
    bool slopes = false;    ///< taken out of the closing speed; else the viscosity is the signal velocity's
    double K = 0.5;         ///< its strength
    bool wide = false;      ///< the cubic spline with h = 1.2 dx, for the narrow kernel
    bool conducts = false;  ///< with (4.9)
};
/// One of the combinations. On a line the narrow kernel is the quadratic spline with h = dx; in the plane,
/// where the recommended kernel is Wendland C4 with h = 1.6 dx, that takes its place.
struct Combination {
    std::string name;       ///< in results.csv, e.g. "signal 0.5 wide conducting"
    std::string viscosity;  ///< for a table's row
    std::string look;       ///< the method whose look it has (method_looks.hpp)
    Parts parts;
    Method<1> line;
    std::optional<Method<2>> plane;  ///< not for all
};

/// The recommended method reduced to these parts.
Combination combination(const Parts& parts);
/// Signal velocities, with K = 0.5 and (narrow kernel) 0.85, the switch of Morris & Monaghan, and slopes
/// taken out; on both kernels; with and without conduction, but for the switch, which has none.
std::vector<Combination> combinations();

}  // namespace sph::shocks
