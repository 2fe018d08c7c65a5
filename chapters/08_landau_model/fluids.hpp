#pragma once
#include <cmath>
#include <numbers>

/// Relativistic equations of state at constant entropy per conserved charge, as small types. n is the density
/// of what is conserved, at rest: of entropy, s, for a fluid without baryons, of baryons for one with them.
///     pressure(n), energy(n) = eps, the energy density with the rest mass,
///     enthalpy(n) = w = (eps + P)/n, the inertia of a unit of charge, sound_speed_squared(n) = d ln w/d ln
///     n.
/// All need n > 0; c = 1.
namespace sph {

/// P = c2 eps, c2 in (0, 1): eps = s^(1 + c2), so that s0 = eps0 = T0 = 1 where w = (1 + c2) T. Landau's slab
/// has c2 = 1/3   (Chen 2017, 209-211).
struct ConformalFluid {
    double c2 = 1.0 / 3;
    double energy(double s) const { return s * temperature(s); }
    double pressure(double s) const { return c2 * energy(s); }
    double enthalpy(double s) const { return (1 + c2) * temperature(s); }
    double sound_speed_squared(double) const { return c2; }
    double temperature(double s) const { return c2 == 1.0 / 3 ? std::cbrt(s) : std::pow(s, c2); }
};

/// Massless pions, three degrees of freedom, in units of hbar = c = k = 1: P = eps/3 = C s^(4/3),
/// C = (15/(128 pi^2))^(1/3)   (221, 222; the text calls it a baryon gas, but it has none).
struct PionGas {
    inline static const double C = std::cbrt(15 / (128 * std::numbers::pi * std::numbers::pi));
    double pressure(double s) const { return C * s * std::cbrt(s); }
    double energy(double s) const { return 3 * pressure(s); }
    double enthalpy(double s) const { return 4 * C * std::cbrt(s); }
    double sound_speed_squared(double) const { return 1.0 / 3; }
};

/// An ideal gas of baryons of mass 1, P = (gamma - 1) n u, at one entropy: P = K n^gamma, gamma in (1, 2],
/// K > 0   (Monaghan 2005, after 12.2).
struct BaryonGas {
    double gamma = 5.0 / 3, K = 1;
    double pressure(double n) const { return K * std::pow(n, gamma); }
    double energy(double n) const { return n + pressure(n) / (gamma - 1); }
    double enthalpy(double n) const { return 1 + gamma / (gamma - 1) * K * std::pow(n, gamma - 1); }
    double sound_speed_squared(double n) const {
        const double thermal = enthalpy(n) - 1;
        return (gamma - 1) * thermal / (1 + thermal);
    }
};

}  // namespace sph
