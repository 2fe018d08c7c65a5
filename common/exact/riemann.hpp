#pragma once

namespace exact {

/// The Riemann problem of an ideal gas, P = (gamma-1) rho u: two uniform states that meet at x = 0 at t = 0.
/// Exact, vacuum included.
///
/// Between the waves pressure and velocity are p_star and v_star, the root of
///     f_L(p) + f_R(p) + v_R - v_L = 0,   v_star = (v_L + v_R)/2 + (f_R - f_L)/2,
///     f_K(p) = (p - p_K) sqrt[A_K/(p + B_K)]  across a shock, p > p_K,
///              A_K = 2/((gamma+1) rho_K),  B_K = (gamma-1)/(gamma+1) p_K,
///            = 2 c_K/(gamma-1) [(p/p_K)^((gamma-1)/(2 gamma)) - 1]  across a rarefaction.
/// Source: Toro, Riemann Solvers (2009), eqs 4.5-4.9 (the root), 4.46 (two rarefactions), 4.53, 4.56
/// and 4.60, 4.63 (densities and fans), section 4.6 (vacuum).
///
/// Units: of length, time and mass as the caller likes. Accuracy: computed with 64-bit mantissas; p_star and
/// the densities to 1e-14 relative, v_star to 1e-15 of the largest velocity, except where they are
/// ill-conditioned: beside the states that leave a vacuum (p_star goes to zero with a high power).
/// Cost: 1 to 3 microseconds, and less for each place.
class Riemann {
  public:
    static constexpr double largest_gamma = 100;
    static constexpr double largest_scale = 1e100;  ///< of rho, |v| and p

    struct State {
        double rho, v, p;
    };
    struct Star {
        double p, v;                 ///< of both sides of the contact
        double rho_left, rho_right;  ///< beside it
        bool vacuum;  ///< then p and both rho are 0, and v is the middle of the vacuum's fronts
    };
    struct Point {
        double rho, v, p, u;
    };
    /// One wave: the velocities of its edge beside the undisturbed state and of the one beside the contact or
    /// the vacuum; both are equal for a shock, and beside an empty side, where there is no wave.
    struct Wave {
        double head, tail;
        bool shock;
    };
    /// Everything that moves, at x = v t: what a scene's window has to hold.
    struct Waves {
        Wave left;
        double contact;  ///< in a vacuum the middle of its fronts
        Wave right;
    };

    /// rho >= 0, p >= 0 (p = 0 where rho = 0: vacuum), |v|, all up to largest_scale; gamma in (1,
    /// largest_gamma]. Throws std::domain_error, which names the value, outside these ranges, and for two
    /// vacua.
    Riemann(const State& left, const State& right, double gamma);

    Star star() const noexcept { return star_; }
    Waves waves() const noexcept { return waves_; }
    /// The state at x/t = xi [velocity], any finite value; 0 in the vacuum. At a discontinuity the state on
    /// its right.
    Point at(double xi) const;
    /// The same at x and t >= 0; at t = 0 the initial states, the right one at x = 0.
    Point at(double x, double t) const;

  private:
    State left_, right_;
    double gamma_;
    Star star_{};
    Waves waves_{};
};

}  // namespace exact
