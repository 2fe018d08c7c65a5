#pragma once

namespace exact {

/// Steady supersonic flow of an ideal gas that a straight wall turns by an angle: a shock where the wall
/// turns into the flow, a fan where it turns away. Angles in radians, Mach numbers and ratios are pure
/// numbers; ratios are behind over ahead.
struct TurnedFlow {
    static constexpr double largest_gamma = 100, largest_mach = 1e6;
};

/// An oblique shock, attached to the corner of a wall that turns into the flow:
///     tan(angle) = 2 cot(beta) (n - 1)/[M^2 (gamma + cos 2 beta) + 2],   n = M^2 sin^2 beta,
/// beta the angle between shock and flow ahead. Two shocks turn a flow by one angle; behind the weak one,
/// which is found where nothing downstream asks for more pressure, the flow is supersonic but for the last
/// fraction of a degree. Beyond the largest angle, at
///     sin^2 beta = {(gamma+1) M^2/4 - 1 + [(gamma+1) (1 + (gamma-1) M^2/2 + (gamma+1) M^4/16)]^(1/2)}/(gamma
///     M^2),
/// there is none: the shock stands off the corner.
/// Source: NACA Report 1135 (1953), eqs 128, 132, 139a, 168. Accuracy: measured 4e-15 of the angle but for
/// the last 1e-12 of it, where beta has a square root.
class ObliqueShock : public TurnedFlow {
  public:
    enum class Branch { weak, strong };

    /// mach in (1, largest_mach]; gamma in (1, largest_gamma]; angle in 0..largest_angle(mach, gamma), 0 the
    /// wave of Mach (weak) or the normal shock (strong). Throws std::domain_error, which names the value.
    ObliqueShock(double mach, double angle, double gamma, Branch branch = Branch::weak);

    double beta() const { return beta_; }
    double mach_behind() const;
    double p_ratio() const;
    double rho_ratio() const;

    /// The largest angle by which an attached shock turns a flow of that Mach number.
    static double largest_angle(double mach, double gamma);

  private:
    double mach_, angle_, gamma_, beta_;
    double normal2_;  ///< of the Mach number normal to the shock, its square
};

/// A fan of Prandtl and Meyer, at the corner of a wall that turns away from the flow:
///     nu(M_2) = nu(M_1) + angle,   nu = k arctan(root/k) - arctan(root),   root^2 = M^2 - 1,   k^2 =
///     (gamma+1)/(gamma-1),
/// at constant entropy. Source: NACA Report 1135 (1953), eqs 44, 45, 171c. Accuracy: measured 3e-15.
class PrandtlMeyer : public TurnedFlow {
  public:
    /// mach in 1..largest_mach; gamma in (1, largest_gamma]; angle from 0 to below the one that leads into
    /// the vacuum, largest_angle(mach, gamma). Throws std::domain_error, which names the value.
    PrandtlMeyer(double mach, double angle, double gamma);

    double mach_behind() const { return mach_behind_; }
    double p_ratio() const;
    double rho_ratio() const;
    /// The Mach number on the ray that leaves the corner at an angle to the flow ahead, > 0 away from the
    /// wall: waves stand at arcsin(1/M) to the flow, so that in the fan
    ///     ray = arcsin(1/M) - [nu(M) - nu(M_1)].
    double mach_on_ray(double ray) const;

    /// The angle nu(mach) by which a flow at the speed of sound has to turn to get there.
    static double nu(double mach, double gamma);
    static double largest_angle(double mach, double gamma);

  private:
    double mach_, gamma_, mach_behind_;
};

}  // namespace exact
