#pragma once

namespace exact {

/// The Noh problem: cold gas of density rho0 that rushes at speed v0 to the plane (dimension d = 1), the axis
/// (d = 2) or the point (d = 3) x = 0 since t = 0, and is stopped there by a shock that runs outwards;
/// p = (gamma-1) rho u. With the shock at R = (gamma-1)/2 v0 t, for x >= 0,
///     rho = rho0 ((gamma+1)/(gamma-1))^d,   v = 0,     u = v0^2/2,   p = (gamma-1) rho u   for x <= R,
///     rho = rho0 (1 + v0 t/x)^(d-1),        v = -v0,   u = p = 0                           for x > R.
/// Ahead of the shock each element keeps its velocity, so the shell at x was at x + v0 t and had (x/(x + v0
/// t))^(d-1) of its density; at the shock that is ((gamma+1)/(gamma-1))^(d-1), and a strong shock compresses
/// by (gamma+1)/(gamma-1) more.
/// Source: Noh, J. Comput. Phys. 72 (1987) 78, whose case is gamma = 5/3, rho0 = v0 = 1, t = 0.6: then R =
/// 0.2 and rho = 4^d rho0.
///
/// Units: of length, time and mass as the caller likes. Accuracy: rounding, 1e-15.
class Noh {
  public:
    static constexpr double largest_gamma = 100;
    static constexpr double least_scale = 1e-50, largest_scale = 1e50;  ///< of density and speed

    /// dimension 1, 2 or 3; gamma in (1, largest_gamma]; density rho0 [mass/length^dimension] and speed v0
    /// [length/time] in least_scale..largest_scale.
    /// Throws std::domain_error, which names the value, outside these ranges.
    Noh(int dimension, double gamma, double density, double speed);

    struct State {
        double rho, v, p, u;
    };

    /// The state at time t in 0..largest_scale and x: any finite number for dimension 1, where x < 0 is the
    /// mirror image with v = +v0 ahead of the shock; a distance x >= 0 and the radial velocity for dimensions
    /// 2 and 3. The shock itself, and x = 0 always, have the state behind it.
    /// Throws std::domain_error, which names the value, outside these ranges.
    State at(double x, double t) const;

    State post_shock() const;  ///< behind the shock, at all times
    /// Where the shock is at t in 0..largest_scale [length]; throws std::domain_error for other t.
    double shock_position(double t) const;
    double shock_speed() const { return (gamma_ - 1) / 2 * speed_; }

  private:
    int dimension_;
    double gamma_, density_, speed_;
};

}  // namespace exact
