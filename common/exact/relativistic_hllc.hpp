#pragma once
#include <cmath>
#include <cstddef>

#include "common/exact/hllc.hpp"
#include "common/exact/relativistic_fluids.hpp"

/// The faces of the relativistic finite-volume scheme, which may move. All is free of branches, and inline,
/// so that loops over it are vectorised.
namespace exact::relativistic {

/// What a face knows of the state beside it.
template <class Fluid>
struct Side {
    double v, p;
    typename Fluid::Values u;  ///< conserved
    double slow, fast;         ///< speeds of sound waves to the left and to the right

    /// Through a face of velocity `face`: F - face U with F = (S v + p, (tau + p) v, D v).
    typename Fluid::Values flux(double face) const {
        typename Fluid::Values f;
        for (std::size_t k = 0; k < f.size(); ++k) f[k] = (v - face) * u[k];
        f[0] += p, f[1] += p * v;
        return f;
    }
};

/// slow, fast = (v -+ c_s)/(1 -+ v c_s), in a form that keeps the digits of v -+ 1.
template <class Fluid>
inline Side<Fluid> side(const Fluid& fluid, const typename Fluid::Values& q) {
    const Motion m{q[0]};
    const double c2 = fluid.sound_speed_squared(q), scale = 1 / (1 - m.v * m.v * c2);
    const double drift = m.v * (1 - c2) * scale, spread = std::sqrt(c2) * m.slow * m.slow * scale;
    return {m.v, fluid.pressure(q), fluid.conserved(q, m), drift - spread, drift + spread};
}

/// As a selection of values, see hllc.hpp.
template <class Fluid>
inline Side<Fluid> choose(bool first, const Side<Fluid>& a, const Side<Fluid>& b) {
    Side<Fluid> chosen{first ? a.v : b.v, first ? a.p : b.p, {}, 0, 0};
    for (std::size_t k = 0; k < a.u.size(); ++k) chosen.u[k] = first ? a.u[k] : b.u[k];
    return chosen;
}

/// Speeds of the outer waves.
struct Fan {
    double left, right;
};
/// The fastest sound waves of both sides. Source: Davis, SIAM J. Sci. Stat. Comput. 9 (1988) 445, in the
/// relativistic form of Mignone & Bodo, MNRAS 364 (2005) 126.
template <class Fluid>
inline Fan fan(const Side<Fluid>& l, const Side<Fluid>& r) {
    return {hllc::smaller(l.slow, r.slow), hllc::larger(l.fast, r.fast)};
}

/// HLL: one state between the outer waves. For a fluid whose only waves are these.
inline BaryonFreeFluid::Values flux(const Side<BaryonFreeFluid>& l, const Side<BaryonFreeFluid>& r,
                                    const Fan& waves, double face) {
    const auto weight = hllc::hll_weights({waves.left - face, waves.right - face, 0, 0});
    const auto f_l = l.flux(face), f_r = r.flux(face);
    return {weight.l * f_l[0] + weight.r * f_r[0] + weight.j * (r.u[0] - l.u[0]),
            weight.l * f_l[1] + weight.r * f_r[1] + weight.j * (r.u[1] - l.u[1])};
}

/// HLLC: a contact between the outer waves, of speed v*, with p* on both sides. With E = tau + D and
///     A_K = S_K E_K - m_K,   B_K = m_K (S_K - v_K) - p_K      (m the momentum, S_L and S_R the waves)
/// the jump across S_K gives p* = (A_K v* - B_K)/(1 - S_K v*), so v* is the root in (S_L, S_R) of
///     (A_R S_L - A_L S_R) v*^2 + (A_L + S_R B_L - A_R - S_L B_R) v* + B_R - B_L = 0,
/// and then   (S_K - v*) U*_K = (S_K - v_K) U_K + (p* - p_K, p* v* - p_K v_K, 0).
/// Source: Mignone & Bodo (2005), eqs 16-18, with tau for E.
inline RelativisticGas::Values flux(const Side<RelativisticGas>& l, const Side<RelativisticGas>& r,
                                    const Fan& waves, double face) {
    const double a_l = waves.left * (l.u[1] + l.u[2]) - l.u[0], b_l = l.u[0] * (waves.left - l.v) - l.p;
    const double a_r = waves.right * (r.u[1] + r.u[2]) - r.u[0], b_r = r.u[0] * (waves.right - r.v) - r.p;
    const double square = a_r * waves.left - a_l * waves.right, constant = b_r - b_l;
    const double linear = a_l + waves.right * b_l - a_r - waves.left * b_r;  // < 0
    const double root = std::sqrt(hllc::larger(linear * linear - 4 * square * constant, 0));
    Side<RelativisticGas> star{};
    star.v = 2 * constant / (root - linear);

    // Where all waves run to one side, as at large W, v* may be 0/0 and does not matter.
    const bool to_right = waves.left > face, to_left = waves.right < face;
    const bool from_left = to_right || hllc::both(!to_left, star.v > face);
    const Side<RelativisticGas> k = choose(from_left, l, r);
    const double speed = from_left ? waves.left : waves.right, scale = 1 / (speed - star.v);
    star.p = ((from_left ? a_l : a_r) * star.v - (from_left ? b_l : b_r)) / (1 - speed * star.v);
    star.u = {((speed - k.v) * k.u[0] + star.p - k.p) * scale,
              ((speed - k.v) * k.u[1] + star.p * star.v - k.p * k.v) * scale, (speed - k.v) * k.u[2] * scale};
    return choose(to_right | to_left, k, star).flux(face);
}

}  // namespace exact::relativistic
