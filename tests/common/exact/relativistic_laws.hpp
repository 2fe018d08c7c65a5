#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "common/exact/relativistic_riemann.hpp"

/// Whether waves of a relativistic ideal gas (c = 1) obey the conservation laws, in the formulas of
/// textbooks.
namespace relativistic_laws {

using exact::RelativisticRiemann;
using Real = long double;

/// Conserved densities D = rho W, S = rho h W^2 v, E = rho h W^2 - p (tau = E - D) and their fluxes in a
/// frame in which the gas has this rapidity.
struct Flow {
    std::array<Real, 3> density, flux;

    Flow(Real rho, Real rapidity, Real p, Real gamma) {
        const Real W = std::cosh(rapidity), Wv = std::sinh(rapidity), rho_h = rho + gamma / (gamma - 1) * p;
        density = {rho * W, rho_h * W * Wv, rho_h * W * W - p};
        flux = {rho * Wv, rho_h * Wv * Wv + p, rho_h * W * Wv};
    }
    Flow(const RelativisticRiemann::Point& at, Real gamma) : Flow{at.rho, at.rapidity, at.p, gamma} {}
};

/// One side of a problem as if it were the left one, and what became of it.
struct Passage {
    Real rho, rapidity, p;  ///< ahead of the wave
    Real rho_star, rapidity_star, p_star;
    Real wave;  ///< rapidity of the shock
    bool shock;
};
inline Passage left_passage(const RelativisticRiemann& solution, const RelativisticRiemann::State& left) {
    const auto& star = solution.star();
    const auto& wave = solution.waves().left;
    return {left.rho, std::atanh(Real{left.v}), left.p,    star.rho_left, star.rapidity,
            star.p,   wave.head.rapidity,       wave.shock};
}
inline Passage right_passage(const RelativisticRiemann& solution, const RelativisticRiemann::State& right) {
    const auto& star = solution.star();
    const auto& wave = solution.waves().right;
    return {right.rho, -std::atanh(Real{right.v}), right.p,   star.rho_right, -star.rapidity,
            star.p,    -wave.head.rapidity,        wave.shock};
}

/// The fluxes of D, S and E on both sides of a shock, in its frame: the relative difference, over what the
/// rounding of the rapidities to doubles makes of it.
inline double shock_error(const Passage& side, Real gamma) {
    const Real ahead = side.rapidity - side.wave, behind = side.rapidity_star - side.wave;
    const Flow a{side.rho, ahead, side.p, gamma}, b{side.rho_star, behind, side.p_star, gamma};
    Real error = 0;
    for (std::size_t k = 0; k < 3; ++k) error = std::max(error, std::abs(a.flux[k] / b.flux[k] - 1));
    const Real sizes = std::abs(side.rapidity) + std::abs(side.rapidity_star) + std::abs(side.wave);
    return static_cast<double>(error / (1 + sizes * (1 / std::tanh(ahead) + 1 / std::tanh(behind))));
}

/// F of exact::RelativisticRiemann by the logarithm of the speed of sound, with (k - c_s)(k + c_s) = k^2/h
/// where hot gas has c_s near k = sqrt(gamma-1).
inline Real expansion(Real rho, Real p, Real gamma) {
    const Real k = std::sqrt(gamma - 1), w = gamma / (gamma - 1) * p / rho;  // h - 1
    const Real c_s = std::sqrt(gamma * p / (rho * (1 + w)));
    return (2 * std::log1p(c_s / k) + std::log1p(w)) / k;
}

/// The Riemann invariant y + F and the entropy on both sides of a rarefaction: differences, that of y + F
/// over the size of its terms.
inline double rarefaction_error(const Passage& side, Real gamma) {
    const Real F = expansion(side.rho, side.p, gamma);
    const Real F_star = expansion(side.rho_star, side.p_star, gamma);
    const Real invariant = std::abs(side.rapidity + F - side.rapidity_star - F_star) /
                           (std::abs(side.rapidity) + std::abs(side.rapidity_star) + F);
    const Real entropy = std::log(side.p_star / side.p) - gamma * std::log(side.rho_star / side.rho);
    return static_cast<double>(std::max(invariant, std::abs(entropy)));
}

inline RelativisticRiemann::State mirrored(const RelativisticRiemann::State& state) {
    return {state.rho, -state.v, state.p};
}

}  // namespace relativistic_laws
