#pragma once

namespace exact {

/// Gas that expands into the vacuum: at rest with density rho0 and specific thermal energy u0 in |x| < a at
/// t = 0, nothing outside; P = (gamma-1) rho u. Two rarefactions run inwards at the speed of sound c0, and
/// the gas outwards at up to 2 c0/(gamma-1). Until they meet at x = 0, on the side x > 0,
///     head(t) = a - c0 t,   front(t) = a + 2 c0 t/(gamma-1),   c0^2 = gamma (gamma-1) u0,
///     v = 2/(gamma+1) (x - head)/t,   c = c0 - (gamma-1)/2 v   between them,
///     rho = rho0 (c/c0)^(2/(gamma-1)),   p = p0 (c/c0)^(2 gamma/(gamma-1)),   u = u0 (c/c0)^2,
/// and mirrored on the other side.
/// Source: Toro, Riemann Solvers (2009), eq. 4.56 (the fan) and section 4.6.1 (vacuum beside it). The problem
/// is that of Monaghan (2005), section 9, figure 14: rho0 = 1, u0 = 2, gamma = 1.4, a = 0.5.
///
/// Units: of length, time and mass as the caller likes, u in length^2/time^2. Accuracy: rounding of x, a and
/// front(t), which counts beside the front, where rho goes to zero steeply: measured 5e-15 of rho, v, p and
/// u, and 3e-14 where 0.05 of the fan's width is left.
class Rarefaction {
  public:
    static constexpr double largest_gamma = 100;
    static constexpr double least_scale = 1e-100, largest_scale = 1e100;  ///< of rho0, u0, half_width

    /// rho0, u0, half_width in least_scale..largest_scale; gamma in (1, largest_gamma].
    /// Throws std::domain_error, which names the value, outside these ranges.
    Rarefaction(double rho0, double u0, double gamma, double half_width);

    struct State {
        double rho, v, p, u;
    };

    // The four functions that follow take t in 0..meeting_time(). They throw std::domain_error, which names
    // the value, for other t, and for an x or x0 out of range.

    /// The state at any finite x; 0 in the vacuum, from the front on. For t = 0 the edges |x| = a are gas.
    State at(double x, double t) const;

    /// Where the fluid element is at time t that was at x0 at t = 0, -a..a: at x0 until the head reaches it
    /// at t_0 = (a - |x0|)/c0, then, from dx/dt = v(x, t), on the side x0 > 0 at
    ///     x = a + 2 c0 t/(gamma-1) - (gamma+1)/(gamma-1) c0 t (t_0/t)^((gamma-1)/(gamma+1)).
    double trajectory(double x0, double t) const;

    /// Places on the side x > 0: the vacuum begins at the front, the gas at rest ends at the head.
    double front(double t) const;
    double head(double t) const;

    double sound_speed() const { return c0_; }                 ///< c0, of the gas at rest
    double meeting_time() const { return half_width_ / c0_; }  ///< a/c0, when the two heads meet at x = 0

  private:
    void require_time(double t) const;
    State at_rest() const;

    double rho0_, u0_, gamma_, half_width_, c0_;
};

}  // namespace exact
