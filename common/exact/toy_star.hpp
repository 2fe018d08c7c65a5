#pragma once
#include "common/exact/toy_star_orbit.hpp"

namespace exact {

/// The toy star that pulsates with any amplitude, in one dimension: the exact solution of
///     dv/dt = -(1/rho) dP/dx - Omega^2 x,  P = K rho^gamma                     Monaghan (2005), eq. 6.17,
///     v = A(t) x,   rho^(gamma-1) = H(t) - C(t) x^2                            eqs 6.18, 6.19,
/// which leave
///     A' = -A^2 + 2 gamma K/(gamma-1) C - Omega^2,   H' = -(gamma-1) A H,   C' = -(gamma+1) A C.
/// Every place moves with the radius, x = lambda(t) x(0), and
///     lambda'' = -Omega^2 lambda + B lambda^(-gamma),   B = 2 gamma K C_0 / (gamma-1),
///     A = lambda'/lambda,   H = H_0 lambda^(-(gamma-1)),   C = C_0 lambda^(-(gamma+1)),
/// which toy_star_orbit.hpp solves; the star rests for A_0 = 0, B = Omega^2.
///
/// Units: of length, time and mass as the caller likes; Omega, A and 1/t in one unit, H in that of
/// rho^(gamma-1), C of rho^(gamma-1)/length^2, K of P/rho^gamma.
/// Accuracy: the state of a time that differs from t by less than 1e-15 (|t| + 4/Omega), for every gamma and
/// amplitude; errors do not grow otherwise. Measured, at 34 places with gamma 1.05..7, |A_0| up to 10 Omega
/// and Omega t up to 200: 5.8e-14 of H, C, the radius and hypot(A, Omega); 4.4e-15 up to Omega t = 3. Cost:
/// 30 to 170 microseconds a star, 10 to 40 a time.
class ToyStar {
  public:
    static constexpr double largest_gamma = 100;
    static constexpr double least_omega = 1e-3, largest_omega = 1e3;  ///< of Omega
    static constexpr double least_scale = 1e-6, largest_scale = 1e6;  ///< of K, H0 and C0
    static constexpr double largest_rate = 1e6;                       ///< of |A0|
    static constexpr double largest_time = 1e4;                       ///< of |t|

    /// gamma in (1, largest_gamma]; K, H0, C0 in least_scale..largest_scale; Omega in
    /// least_omega..largest_omega; |A0| <= largest_rate.
    /// Throws std::domain_error, which names the value, outside these ranges, and for an A0 with
    /// which C might leave e^-300..e^300 times its value at rest.
    ToyStar(double gamma, double K, double Omega, double A0, double H0, double C0);

    struct State {
        double A, H, C;
        double radius;  ///< sqrt(H/C)
        double gamma;

        /// A x, also outside the star.
        double velocity(double x) const { return A * x; }
        /// [C (radius - x) (radius + x)]^(1/(gamma-1)), 0 outside the star.
        double density(double x) const;
    };

    /// The state at time t, also before 0; |t| <= largest_time.
    /// Throws std::domain_error, which names the value, outside this range.
    State at(double t) const;

    /// Density and velocity at (x, t). For many x at one t, take `at(t)` once.
    double density(double x, double t) const { return at(t).density(x); }
    double velocity(double x, double t) const { return at(t).velocity(x); }

    double period() const { return orbit_.period() / Omega_; }

  private:
    double gamma_, Omega_, H0_, C0_;
    double log_q0_;  ///< ln of the initial radius over that at rest
    ToyStarOrbit orbit_;
};

}  // namespace exact
