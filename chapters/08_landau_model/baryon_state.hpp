#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

/// An ideal gas of baryons, P = (gamma - 1) n u, h = 1 + gamma u, in the frame of the laboratory
/// (Monaghan 2005, 12.2, 12.5; Chow & Monaghan 1997). Per baryon, with the lab density n* = n lorentz,
///     q = h lorentz v,   E = h lorentz - P/n*    (momentum and energy, rest mass included).
namespace sph {

/// What a particle's q, E and n* say about it.
struct BaryonState {
    double U = 0, lorentz = 1, v = 0;  // U = lorentz v
    double u = 0, p = 0, h = 1, c_s = 0;
    int evaluations = 0;  ///< of f
    bool sound = false;   ///< false: q and E belong to no gas with u > 0, and the rest means nothing
};

/// q and E of gas with rest density n, velocity v and pressure p.
struct MomentumEnergy {
    double q, E;
};
inline MomentumEnergy momentum_energy(double n, double v, double p, double gamma) {
    const double lorentz = 1 / std::sqrt((1 - v) * (1 + v)), h = 1 + gamma / (gamma - 1) * p / n;
    return {h * lorentz * v, h * lorentz - p / (n * lorentz)};
}

/// Solves for the share P/n* of the energy: with Z = E + P/n* = h lorentz and v = q/Z,
///     f(P/n*) = (gamma - 1) u/lorentz - P/n* = 0, u = (Z/lorentz - 1)/gamma,   f' = (v^2 c_s^2 - 1)/gamma <
///     0,
/// by Newton's method in the bracket (0, (gamma - 1) E). There is a root if E > sqrt(1 + q^2), the energy of
/// cold gas. The Lorentz factor comes with a relative error of about 1e-16 lorentz^2, as E - |q| has lost
/// these digits: the price of evolving E, which recovery.hpp does not pay.
/// `guess` of p, 0 if there is none. Cost: 2 or 3 evaluations from a guess within 10^-3, up to 12 without
/// one.
inline BaryonState recover_baryons(double q, double E, double n_star, double gamma, double guess = 0) {
    constexpr int most = 100;
    constexpr double close = 1e-12;
    BaryonState state;
    const double momentum = std::abs(q);
    if (!((E - momentum) * (E + momentum) > 1 && n_star > 0 && std::isfinite(E) && std::isfinite(n_star)))
        return state;
    double low = 0, high = (gamma - 1) * E, share = guess / n_star;
    if (!(share > low && share < high)) share = 0.5 * std::min(high, (gamma - 1) * (E - momentum));
    for (int k = 0; k < most; ++k) {
        ++state.evaluations;
        const double Z = E + share, v = momentum / Z, lorentz = 1 / std::sqrt((1 - v) * (1 + v));
        const double u = (Z / lorentz - 1) / gamma, f = (gamma - 1) * u / lorentz - share;
        (f > 0 ? low : high) = share;
        const double c2 = gamma * (gamma - 1) * u / (1 + gamma * u);
        const double step = gamma * f / (1 - v * v * std::max(c2, 0.0));
        // Of f, a difference of terms below Z, digits beyond that of Z are rounding.
        const bool done =
            std::abs(step) < close * share || std::abs(f) < std::numeric_limits<double>::epsilon() * Z;
        double next = share + step;
        if (!done && !(next > low && next < high)) next = 0.5 * (low + high);
        if (next == share) break;
        share = next;
        if (done) break;
    }
    const double Z = E + share, v = momentum / Z;
    state.lorentz = 1 / std::sqrt((1 - v) * (1 + v));
    state.v = q / Z;
    state.U = state.lorentz * state.v;
    state.h = Z / state.lorentz;
    state.u = (state.h - 1) / gamma;
    state.p = share * n_star;
    state.c_s = std::sqrt(gamma * (gamma - 1) * std::max(state.u, 0.0) / state.h);
    state.sound = state.u > 0 && state.p > 0 && std::isfinite(state.lorentz);
    return state;
}

}  // namespace sph
