#pragma once

/// The middle of the Landau slab, where the two simple waves run through each other: the flow from its
/// potential. Where and when is the fluid at the temperature T = e^-omega and the rapidity y? With
/// a = y/sqrt3, q(z) = sqrt(z^2 - a^2) and the modified Bessel functions I0 and I1 the potential is
///     chi = -sqrt3 e^zeta int_a^omega e^(2z) I0(q) dz,   zeta = ln T = -omega,
///     t     = e^-zeta (dchi/dzeta cosh y - dchi/dy sinh y),
///     x - 1 = e^-zeta (dchi/dzeta sinh y - dchi/dy cosh y).
/// Source: Chen (2017), eqs 215-217, where 217 has x for x - 1; Khalatnikov (1954); Wong et al., Phys. Rev. C
/// 90 (2014) 064907. Units: half the slab's width, c = 1, and the state of the slab at t = 0.
///
/// Here e^zeta sinh y is taken off chi, which moves the origin of x from the edge to the centre and makes chi
/// even in y, and the integral over I0 is by parts, so that nothing cancels, not near x = 0 either:
///     U = e^-zeta dchi/dzeta = sqrt3 [e^(2a) + int_a^omega e^(2z) (I0 + z I1/q) dz] - sinh y,
///     V = e^-zeta dchi/dy    = e^(2a) - cosh y + a int_a^omega e^(2z) I1/q dz,
///     t + x = e^y (U - V),   t - x = e^-y (U + V).
/// V without cosh y is e^-zeta times eq. 219, which is printed as dchi/dzeta, with -sqrt3 for the factor a.
///
/// Nothing here checks its arguments: LandauSlab does.
namespace exact::khalatnikov {

/// Of the fluid: omega = ln(1/T) >= 0, rapidity 0 <= y <= sqrt3 omega. Times are up to largest_time.
struct State {
    double omega, y;
};

constexpr double largest_time = 1e6;

/// Of the weak discontinuity, where y = sqrt3 omega as in the simple wave, at t > sqrt3: the root omega of
///     t = sqrt2 e^(2 omega) cosh(sqrt3 omega - artanh(1/sqrt3)).
State weak_discontinuity(double t);

/// The state at t > sqrt3 and 0 <= x <= x(weak_discontinuity(t)). Newton's method from `guess` for
///     artanh(x/t) = y - artanh(V/U),   ln(t^2 - x^2) = ln(U^2 - V^2),
/// which are nearly linear in y and omega, with the derivatives
///     dU/domega = sqrt3 e^(2 omega) (I0 + omega I1/q),   dV/domega = a e^(2 omega) I1/q   at q(omega),
///     dU/dy = V - dV/domega,   dV/dy = U - dU/domega/3,
/// of which the last one is Khalatnikov's equation: the integrals serve twice. `guess` may be any state of
/// omega <= 8; from LandauSlab's at most four evaluations are needed.
State state_at(double t, double x, const State& guess);

/// The entropy of all fluid beyond x(state), where the whole slab has 2:
///     e^-a + a int_a^omega e^-z I1/q dz,
/// as the entropy N between the centre and x has dN = s (cosh y dx - sinh y dt), from which
/// dN/domega = -a e^-omega I1/q at constant a, and N = 1 - e^-a at the weak discontinuity, omega = a.
double entropy_beyond(const State& state);

}  // namespace exact::khalatnikov
