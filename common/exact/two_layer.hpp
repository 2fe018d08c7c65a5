#pragma once

namespace exact {

/// Steady plane flow of two fluids in layers, along two walls: the one at y = 0 stands still, the one at
/// y = height moves along x with `speed`; `force` by volume drives both fluids along x (a body force, or
/// minus the slope of the pressure). What is left of the Navier-Stokes equations is
///     0 = d tau/dy + force,   tau = mu dv/dy,   v and tau continuous,   v = the walls' at the walls,
/// so that tau is a straight line, and v a parabola in each layer: with force = 0 plane Couette flow, a
/// straight line in each, with speed = 0 plane Poiseuille flow (Landau & Lifshitz, Fluid Mechanics (1987),
/// section 17, for one fluid).
///
/// Units: of length, time and mass as the caller likes. mu is the DYNAMIC viscosity, nu rho. Accuracy:
/// rounding, 1e-15 of the largest velocity and stress.
class TwoLayer {
  public:
    static constexpr double least_scale = 1e-30, largest_scale = 1e30;  ///< of viscosities and height

    struct Problem {
        double lower_viscosity = 1;  ///< mu below the interface [mass/(length time)], least..largest_scale
        double upper_viscosity = 1;  ///< and above it
        double interface = 0.5;      ///< where it lies, in parts of the height: above 0 and below 1
        double height = 1;           ///< between the walls [length], least..largest_scale
        double speed = 1;            ///< of the upper wall [length/time], up to largest_scale either way
        double force = 0;  ///< by volume, along x [mass/(length^2 time^2)], up to largest_scale either way
    };
    /// Throws std::domain_error, which names the value, outside these ranges.
    explicit TwoLayer(const Problem& problem);

    struct State {
        double v, tau;  ///< velocity along x, shear stress [mass/(length time^2)]
    };
    /// y in 0..height; throws std::domain_error, which names the value, elsewhere.
    State at(double y) const;

  private:
    Problem problem_;
    double wall_stress_;  // tau at y = 0
};

}  // namespace exact
