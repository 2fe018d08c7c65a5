#pragma once

namespace exact {

/// Decaying Taylor-Green vortices: an incompressible viscous fluid in a periodic square of side L,
///     v_x = -V cos(kx) sin(ky) exp(-bt),   v_y = V sin(kx) cos(ky) exp(-bt),   k = 2 pi/L,   b = 2 nu k^2,
///     p = -rho V^2/4 [cos(2kx) + cos(2ky)] exp(-2bt),   with the mean 0.
/// The advection of the vortices is balanced by the pressure alone, so that each component just diffuses:
/// an exact solution of the Navier-Stokes equations at any Reynolds number V L/nu.
/// Source: Taylor, Phil. Mag. 46 (1923) 671. For a fluid of small compressibility only, add p to the
/// background pressure.
///
/// Units: of length, time and mass as the caller likes. nu is the KINEMATIC viscosity, mu/rho. Accuracy:
/// rounding, 1e-15 of V and of rho V^2; x and y are reduced to one period exactly.
class TaylorGreen {
  public:
    static constexpr double least_scale = 1e-50, largest_scale = 1e50;  ///< of speed, side and density

    /// viscosity nu in 0..largest_scale [length^2/time]; speed V [length/time], the largest of all velocities
    /// at t = 0, side L [length] and density rho [mass/length^2] in least_scale..largest_scale.
    /// Throws std::domain_error, which names the value, outside these ranges.
    TaylorGreen(double viscosity, double speed, double side, double density);

    struct State {
        double v_x, v_y, p;
    };

    // The two functions that follow take t in 0..largest_scale, and throw std::domain_error, which names the
    // value, for other t, and for x or y that are not finite.

    State at(double x, double y, double t) const;
    /// The mean of (v_x^2 + v_y^2)/2 over the square: V^2/4 exp(-2bt) [length^2/time^2].
    double kinetic_energy(double t) const;

    double decay_rate() const;  ///< b [1/time], of the velocity; energy and pressure decay with 2b

  private:
    double decay(double t) const;

    double viscosity_, speed_, side_, density_;
};

}  // namespace exact
