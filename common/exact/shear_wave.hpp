#pragma once

namespace exact {

/// A shear wave that viscosity damps: a periodic fluid that moves along y, at a speed that depends on x
/// alone,
///     v_y = V sin(k x) exp(-nu k^2 t),   k = 2 pi n/L,   v_x = 0,   uniform density and pressure.
/// Nothing is advected or compressed, so this solves the Navier-Stokes equations of any fluid, of which
/// d v_y/dt = nu d^2 v_y/dx^2 is left (Landau & Lifshitz, Fluid Mechanics (1987), eq. 15.7 with v_x = 0).
///
/// Units: of length and time as the caller likes. nu is the KINEMATIC viscosity, mu/rho. Accuracy: rounding,
/// 1e-15 n of V; x is reduced to one period exactly.
class ShearWave {
  public:
    static constexpr double least_scale = 1e-50, largest_scale = 1e50;  ///< of speed and side
    static constexpr int largest_mode = 1000;

    /// viscosity nu in 0..largest_scale [length^2/time]; speed V [length/time] and side L [length] in
    /// least_scale..largest_scale; mode n, the waves in a side, in 1..largest_mode.
    /// Throws std::domain_error, which names the value, outside these ranges.
    ShearWave(double viscosity, double speed, double side, int mode);

    /// v_y at any finite x and t in 0..largest_scale; throws std::domain_error, which names the value,
    /// elsewhere.
    double velocity(double x, double t) const;

    double decay_rate() const;  ///< nu k^2 [1/time], of the velocity; its energy decays twice as fast

  private:
    double viscosity_, speed_, side_;
    int mode_;
};

}  // namespace exact
