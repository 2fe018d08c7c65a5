#pragma once
#include <array>
#include <cstddef>

#include "common/core/particles.hpp"

/// Particles at rest in uniform pressure on a periodic line, not quite even: what should not move, and does.
/// And what sums over particles make of a constant.
namespace sph::godunov {

struct Resting {
    std::size_t n = 200;     ///< particles in a box of length n spacings; P = rho = spacing = 1
    double jitter = 0.1;     ///< random shift of each, up to this part of a spacing; below 0.5
    unsigned long seed = 1;  ///< of the shifts
};
/// Root mean square of the accelerations in P/(rho dx), Gaussian with h = dx.
struct RestingForces {
    double sph = 0;         ///< P_i/rho_i^2 + P_j/rho_j^2   (Inutsuka 2002, 45)
    double linear = 0;      ///< (58) with V linear
    double cubic = 0;       ///< (66) with V cubic
    double quadrature = 0;  ///< the integral (23), by the trapezoidal rule on a fine grid
    double halves = 0;      ///< h of its own for each particle, half of the integral with either: (79)
    double varying = 0;     ///< the same with h interpolated: GeometricVolume
};
/// Throws std::invalid_argument for a jitter outside [0, 0.5).
RestingForces resting_forces(const Resting& scene);

/// The force by which pairs close where the pressure is -1 everywhere, over their particles' shift, if every
/// second particle of an even line is shifted by 1e-5 to either side [1/time^2; P = rho = spacing = 1].
struct Pairing {
    double sph = 0, linear = 0, cubic = 0;  ///< as in RestingForces
};
Pairing pairing_under_tension();

/// Over a stretch of the line: the sum of (m_j/rho(x)) W, which is 1 (14), that of (m_j/rho_j) W, which
/// should be (19), and the velocity field (34) of particles that move with sin(2 pi x/12), beside theirs.
struct Partition {
    Column x, exact, approximate, field;
    Column particles, velocities;
};
Partition partition(const Resting& scene);

}  // namespace sph::godunov
