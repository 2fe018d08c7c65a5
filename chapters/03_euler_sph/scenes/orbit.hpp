#pragma once
#include <string>

#include "common/core/integrators.hpp"
#include "common/core/vec.hpp"

/// A star on an eccentric orbit around a fixed centre, d2x/dt2 = -x/r^3, semi-major axis 1: which integrator
/// keeps it for long? (Monaghan 2005, section 2.6)
namespace sph::euler {

struct OrbitScene {
    double eccentricity = 0.7;            ///< in [0, 1)
    long evaluations = 400;               ///< of the acceleration, per period
    long periods = 100;                   ///< after which the exact orbit is where it began, at its far end
    std::string integrator = "leapfrog";  ///< kick-drift-kick, or "RK4"
};

struct OrbitRun {
    Column period, energy;        ///< change of the energy, relative, at the end of each period
    Column x, y;                  ///< over the last period
    double angular_momentum = 0;  ///< largest change, relative
    double turn = 0;              ///< of the ellipse's axis at the end [rad]
    double miss = 0;              ///< distance from the exact place at the end [semi-major axes]
};

/// Throws std::invalid_argument for an unknown integrator.
OrbitRun run_orbit(const OrbitScene& scene);

}  // namespace sph::euler
