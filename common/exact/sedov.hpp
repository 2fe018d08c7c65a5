#pragma once

#include "common/exact/sedov_profile.hpp"

namespace exact {

/// The point blast of Sedov, von Neumann and Taylor: at t = 0 the energy E is released at a point (dimension
/// d = 3), on an axis (d = 2; E per length) or on a plane (d = 1; E per area, of both sides together), in a
/// cold gas of density rho0 at rest; p = (gamma-1) rho u. A strong shock runs outwards,
///     R = (E t^2/(alpha rho0))^(1/(d+2)),   dR/dt = 2/(d+2) R/t,
/// and leaves behind it
///     rho = (gamma+1)/(gamma-1) rho0,   v = 2/(gamma+1) dR/dt,   p = 2/(gamma+1) rho0 (dR/dt)^2,
/// farther inside these times the functions of r/R of SedovProfile. alpha follows from the energy,
///     E = S integral (rho v^2/2 + p/(gamma-1)) r^(d-1) dr,   S = 2, 2 pi, 4 pi for d = 1, 2, 3:
///     alpha = 8 S/((d+2)^2 (gamma^2-1)) SedovProfile::energy_integral().
/// Source: Kamm, LA-UR-00-6055 (2000), eqs 5, 13, 14, 16 (the shock), 57 and 58 (alpha).
/// Check: gamma = 1.4: alpha = 1.077486, 0.984074, 0.851072 for d = 1, 2, 3.
///
/// Units: of length, time and mass as the caller likes. Relative accuracy: alpha, R and its speed 1e-15; the
/// state as rounding of r/R, a few 1e-16, leaves it, times the steepness of the profile, which is up to about
/// 3 d/(gamma-1) next to the shock, and d/(gamma-1) for rho and u, 0 for p near the centre.
/// Cost: 30 microseconds, and half a microsecond for each place.
class Sedov {
  public:
    static constexpr double least_scale = 1e-60, largest_scale = 1e60;  ///< of energy, density and time

    /// dimension d = 1, 2 or 3; gamma in 1.001..100, and below 7 for d = 3, from where on a vacuum opens at
    /// the centre; energy E [mass length^2/time^2] and density rho0 [mass/length^d] in
    /// least_scale..largest_scale, where mass is that per length for d = 2, per area for d = 1.
    /// Throws std::domain_error, which names the value, outside these ranges.
    Sedov(int dimension, double gamma, double energy, double density);

    struct State {
        double rho, v, p, u;
    };

    // The four functions that follow take t in least_scale..largest_scale, and throw std::domain_error, which
    // names the value, for other t.

    /// The state at the distance r >= 0; v is radial. At the shock that behind it. At r = 0 rho = v = 0, p is
    /// finite and u infinite, as it is wherever it exceeds the largest double: u ~ r^(-d/(gamma-1)). Throws
    /// std::domain_error, which names the value, for other r.
    State at(double r, double t) const;
    State post_shock(double t) const;     ///< behind the shock, at r = R
    double shock_radius(double t) const;  ///< R
    double shock_speed(double t) const;   ///< dR/dt

    double alpha() const { return alpha_; }

  private:
    int dimension_;
    double gamma_, energy_, density_;
    SedovProfile profile_;
    double alpha_;
};

}  // namespace exact
