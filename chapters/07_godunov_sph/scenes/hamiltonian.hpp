#pragma once
#include "common/core/vec.hpp"

/// Godunov SPH without a Riemann problem: a barotropic gas, P = rho^gamma/gamma, on a periodic line, with one
/// h for all, moved by leapfrog.
namespace sph::godunov {

struct WaveWithoutRiemann {
    std::size_t n = 32;  ///< particles, with spacing, mass, h, density and speed of sound 1
    double gamma = 1.4;
    double amplitude = 0.1;  ///< velocity of the wave over the speed of sound
    double periods = 4;      ///< of the wave: n/c_s each
    long steps = 64;         ///< in a period
};

enum class PairForce {
    integral,  ///< (23) by a fixed quadrature: exactly minus the gradient of the energy
    cubic      ///< (43) with V cubic and the mean pressure of both particles
};

/// The largest change of the energy, sum m v^2/2 + integral rho u(rho) dx (u = rho^(gamma-1)/(gamma (gamma -
/// 1)), the same quadrature), on the way, over the kinetic energy of the start.
double energy_change(const WaveWithoutRiemann& scene, PairForce force);

}  // namespace sph::godunov
