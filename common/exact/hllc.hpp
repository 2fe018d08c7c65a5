#pragma once
#include <cmath>
#include <cstddef>

/// The pieces of a finite-volume scheme for the Euler equations of an ideal gas that do not depend on the
/// grid. All are free of branches, so that loops over them are vectorised.
namespace exact::hllc {

/// A state beside a face; v is the velocity normal to it. rho, p > 0.
struct Gas {
    double rho, v, p;
};

/// Speeds of the outer waves and of the contact, and the pressure beside it.
struct Fan {
    double left, right, contact, pressure;
};

/// The flux through a face at rest: rho v, rho v^2 + p, (E + p) v.
struct Flux {
    double mass, momentum, energy;
};

// As selections of values: gcc 12 does not vectorise std::min and std::max, which select references.
inline double smaller(double a, double b) {
    return a < b ? a : b;
}
inline double larger(double a, double b) {
    return a > b ? a : b;
}
/// Both are computed, so that there is no branch.
inline bool both(bool a, bool b) {
    return (static_cast<int>(a) & static_cast<int>(b)) != 0;
}

/// The waves between two states:
///     S_L = min(v_L - c_L, v~ - c~),   S_R = max(v_R + c_R, v~ + c~)    with Roe's averages v~, c~,
///     S_* = (a_L v_L + a_R v_R + p_L - p_R)/(a_L + a_R),   a_L = rho_L (v_L - S_L), a_R = rho_R (S_R - v_R),
///     p_* = (a_R p_L + a_L p_R + a_L a_R (v_L - v_R))/(a_L + a_R).
/// With these speeds the states between the waves have positive density and internal energy. p_* may be
/// negative where gases recede; it is the flux that keeps the energies positive, and to clip it would not.
/// Source: Toro (2009), eqs 10.37 (S_*), 10.36 (p_*, here from both sides), section 10.5.1 (S_L, S_R);
/// Batten et al., SIAM J. Sci. Comput. 18 (1997) 1553 (positivity).
inline Fan fan(const Gas& l, const Gas& r, double gamma) {
    const double c2_l = gamma * l.p / l.rho, c2_r = gamma * r.p / r.rho;
    const double root_l = std::sqrt(l.rho), root_r = std::sqrt(r.rho);
    const double roots = 1 / (root_l + root_r), share_l = root_l * roots, share_r = root_r * roots;
    const double dv = r.v - l.v;
    const double v = share_l * l.v + share_r * r.v;
    const double c =
        std::sqrt(share_l * c2_l + share_r * c2_r + (gamma - 1) / 2 * share_l * share_r * dv * dv);
    const double left = smaller(l.v - std::sqrt(c2_l), v - c), right = larger(r.v + std::sqrt(c2_r), v + c);
    const double a_l = l.rho * (l.v - left), a_r = r.rho * (right - r.v);
    const double scale = 1 / (a_l + a_r);
    return {left, right, (a_l * l.v + a_r * r.v + l.p - r.p) * scale,
            (a_r * l.p + a_l * r.p - a_l * a_r * dv) * scale};
}

/// The flux of the state that the face x = 0 sees: the upwind one K if all waves run to its other side, else
///     rho_* = rho_K (S_K - v_K)/(S_K - S_*),   v_* = S_*,   p_*,
///     E_*   = [(S_K - v_K) E_K - p_K v_K + p_* S_*]/(S_K - S_*).
/// Source: Toro (2009), eqs 10.38-10.39, in the form of the jump across S_K.
inline Flux flux(const Gas& l, const Gas& r, const Fan& waves, double gamma) {
    const bool from_left = waves.contact > 0;
    const double rho = from_left ? l.rho : r.rho, v = from_left ? l.v : r.v, p = from_left ? l.p : r.p;
    const double speed = from_left ? waves.left : waves.right;
    const bool all_pass = (from_left ? speed : -speed) > 0;
    const double energy = p / (gamma - 1) + rho * v * v / 2;
    const double scale = 1 / (speed - waves.contact);
    const double rho_star = rho * (speed - v) * scale;
    const double energy_star = ((speed - v) * energy - p * v + waves.pressure * waves.contact) * scale;
    const double rho_face = all_pass ? rho : rho_star, v_face = all_pass ? v : waves.contact;
    const double p_face = all_pass ? p : waves.pressure, energy_face = all_pass ? energy : energy_star;
    return {rho_face * v_face, rho_face * v_face * v_face + p_face, (energy_face + p_face) * v_face};
}

/// HLL keeps one state between the outer waves. Its flux is  l F_L + r F_R + j (U_R - U_L)  with these
/// weights:
///     l = b_R/(b_R - b_L),  r = -b_L/(b_R - b_L),  j = b_L b_R/(b_R - b_L),   b_L = min(S_L, 0), b_R =
///     max(S_R, 0).
/// Source: Toro (2009), eq. 10.21.
struct HllWeights {
    double l, r, j;
};
inline HllWeights hll_weights(const Fan& waves) {
    const double b_l = smaller(waves.left, 0), b_r = larger(waves.right, 0), scale = 1 / (b_r - b_l);
    return {b_r * scale, -b_l * scale, b_l * b_r * scale};
}

/// The flux of HLL.
inline Flux hll(const Gas& l, const Gas& r, const HllWeights& weight, double gamma) {
    const double energy_l = l.p / (gamma - 1) + l.rho * l.v * l.v / 2;
    const double energy_r = r.p / (gamma - 1) + r.rho * r.v * r.v / 2;
    const double carried_l = weight.l * l.v - weight.j, carried_r = weight.r * r.v + weight.j;
    return {carried_l * l.rho + carried_r * r.rho,
            carried_l * l.rho * l.v + weight.l * l.p + carried_r * r.rho * r.v + weight.r * r.p,
            carried_l * energy_l + weight.l * l.p * l.v + carried_r * energy_r + weight.r * r.p * r.v};
}

/// The limited difference across a cell, from the differences to the neighbours before and after it: the mean
/// of the two slopes, but no more than what leads to a neighbour's value, and 0 at an extremum.
/// `near_before`, `near_after`: half the cell's width over the distance of the neighbour's centre, 1/2 on
/// cells of one width,
///     f = 2 near_after after,  b = 2 near_before before,   min(|f + b|/2, 2 |after|, 2 |before|).
/// Called monotonised central. Source: van Leer, J. Comput. Phys. 23 (1977) 276; for cells of several widths
/// Mignone, J. Comput. Phys. 270 (2014) 784, section 3.1.
inline double limited(double before, double after, double near_before, double near_after) {
    const double mean = near_after * after + near_before * before;
    const double most = smaller(smaller(2 * std::abs(before), 2 * std::abs(after)), std::abs(mean));
    return before * after > 0 ? std::copysign(most, mean) : 0;
}

/// The largest of n values >= 0, and 0. Eight at a time, as maxima that may not be reordered are not
/// vectorised; ignores NaN.
inline double largest(const double* values, std::size_t n) {
    double lanes[8] = {};
    std::size_t i = 0;
    for (; i + 8 <= n; i += 8) {
        for (std::size_t k = 0; k < 8; ++k) lanes[k] = larger(values[i + k], lanes[k]);
    }
    for (; i < n; ++i) lanes[0] = larger(values[i], lanes[0]);
    double result = 0;
    for (const double lane : lanes) result = larger(lane, result);
    return result;
}

/// False also for NaN.
inline bool all_positive(const double* values, std::size_t n) {
    double failures[8] = {};
    std::size_t i = 0;
    for (; i + 8 <= n; i += 8) {
        for (std::size_t k = 0; k < 8; ++k) failures[k] += values[i + k] > 0 ? 0 : 1;
    }
    for (; i < n; ++i) failures[0] += values[i] > 0 ? 0 : 1;
    double sum = 0;
    for (const double lane : failures) sum += lane;
    return sum == 0;
}

}  // namespace exact::hllc
