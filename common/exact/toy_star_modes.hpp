#pragma once

namespace exact {

/// Small oscillations of the toy star: gas with P = K rho^gamma held together by a linear force,
///     dv/dt = -(1/rho) dP/dx - Omega^2 x                                      Monaghan (2005), eq. 6.17.
/// At rest, with radius 1,
///     rho^(gamma-1) = H (1 - x^2),   H = (gamma-1) Omega^2 / (2 gamma K),
///     c^2 = gamma K rho^(gamma-1) = (gamma-1)/2 Omega^2 (1 - x^2),
/// and a small velocity v(x) exp(i omega t) obeys
///     (gamma-1)/2 (1 - x^2) v'' - gamma x v' + (omega^2/Omega^2 - 1) v = 0,
/// which is Gegenbauer's equation (Abramowitz and Stegun, 22.6.5) with lambda = gamma/(gamma-1) - 1/2: mode n
/// has for v the Gegenbauer polynomial C_j^(lambda)(x) of degree j = n - 1, as section 6.3 says without
/// the formula. Mode 1 moves the star as a whole, with omega = Omega; mode 2 is the pulsation v = x, the
/// small case of ToyStar (toy_star.hpp).
///
/// Ranges of all three functions: gamma in (1, 100] [-]; mode 1..1000; they throw std::domain_error, which
/// names the value, outside of them.
inline constexpr int toy_star_largest_mode = 1000;

/// omega/Omega = sqrt[(gamma-1)/2 j(j-1) + gamma j + 1], j = mode - 1 [-], to rounding.
/// Check: gamma = 2 gives sqrt[(j+1)(j+2)/2].
double toy_star_frequency(double gamma, int mode);

/// C_j^(lambda)(x) / C_j^(lambda)(1) [-], j = mode - 1: 1 at the surface x = 1, and even or odd as j is.
/// x in -1..1 [star radius].
/// Accuracy: 2e-15 absolute; measured 1.4e-15 over nine gamma from 1 + 1e-7 to 100, nine modes to 1000 and
/// eleven x. Cost: 5 nanoseconds a mode.
double toy_star_velocity(double gamma, int mode, double x);

/// Density of the star at rest, radius 1 [mass/length]; K > 0, Omega > 0; x finite [star radius]; 0 outside
/// the star.
double toy_star_density(double gamma, double K, double Omega, double x);

}  // namespace exact
