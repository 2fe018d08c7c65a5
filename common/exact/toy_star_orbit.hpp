#pragma once
#include <vector>

namespace exact {

/// The radius of a pulsating toy star in units of its radius at rest, q, and the time in units of 1/Omega:
///     q'' = -q + q^(-gamma),
/// an oscillation about q = 1 with the energy integral
///     q'^2/2 + V = constant,   V(y) = (e^(2y) - 1)/2 + (e^(-(gamma-1)y) - 1)/(gamma-1),   y = ln q.
/// V has one minimum, V(0) = 0. So s = +-sqrt(2V), with the sign of y, is a smooth increasing function
/// of q, and q'^2 + s^2 = swing^2 makes the orbit a circle:
///     s = swing sin(phase),  q' = swing cos(phase),  dt/d(phase) = s / V_q = s / (q - q^(-gamma)),
/// with an integrand that is analytic also at both ends of the swing and at s = 0. The inner turning point
/// is at phase -pi/2, the outer one at pi/2.
///
/// Nothing is integrated step by step, and periods are subtracted: errors do not grow. q is that of a time
/// which differs from the wanted one by a few units in the last place of period and time.
class ToyStarOrbit {
  public:
    /// gamma in (1, 100]; start: log_q = ln q, speed = q'; finite, and such that (gamma + 1) |ln q| stays
    /// below 300 in all of the swing (the caller's duty).
    ToyStarOrbit(double gamma, double log_q, double speed);

    struct Point {
        double log_q, speed;
    };
    Point at(double time) const;  ///< time since the start, any finite value

    double period() const { return 2 * times_.back(); }

    /// The energy integral as sqrt(2V): the greatest speed q'.
    static double swing(double gamma, double log_q, double speed);

    /// A bound on |ln q| in a swing.
    static double farthest(double gamma, double swing);

  private:
    double log_q_at(double phase) const;
    double slowness(double phase) const;
    double time_between(double from, double to) const;
    double time_from_inner_turn(double phase) const;
    double phase_at(double time) const;

    double gamma_;
    double swing_;
    std::vector<double> edges_;  ///< of the panels of the quadrature, phases from -pi/2 to pi/2
    std::vector<double> times_;  ///< from the inner turning point to each edge
    double start_ = 0;           ///< time from the inner turning point to the start, negative if inward bound
};

}  // namespace exact
