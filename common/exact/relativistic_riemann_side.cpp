#include "common/exact/relativistic_riemann_side.hpp"

#include <algorithm>
#include <cmath>

namespace exact::relativistic_waves {

Side::Side(Real density, Real rapidity_inwards, Real pressure, Real adiabatic_index)
    : rho{density},
      rapidity{rapidity_inwards},
      p{pressure},
      gamma{adiabatic_index},
      k{std::sqrt(gamma - 1)},
      theta{rho > 0 ? p / rho : 0},
      w{gamma / (gamma - 1) * theta} {}

Real Side::expansion() const {
    return 2 / k * std::asinh(std::sqrt(w));
}

/// From c_s^2/(1 - c_s^2) = (gamma-1) w/[1 + (2-gamma) w], which keeps the digits of 1 - c_s.
Real Side::sound(Real w_of_gas) const {
    return std::asinh(k * std::sqrt(w_of_gas / (1 + (2 - gamma) * w_of_gas)));
}

Real Side::head(const Behind& wave) const {
    return rapidity - (wave.shock ? std::asinh(wave.shock_sinh) : sound(w));
}

Real Side::tail(const Behind& wave) const {
    return wave.shock ? head(wave) : rapidity - wave.push - sound(wave.w);
}

/// The difference of two F by arsinh a - arsinh b = arsinh[(a^2 - b^2)/(a sqrt(1+b^2) + b sqrt(1+a^2))].
/// The slope is c_s/gamma.
Side::Behind Side::rarefaction(Real z) const {
    const Real exponent = (gamma - 1) / gamma;
    const Real w_star = w * std::exp(exponent * z);
    const Real lost = -w * std::expm1(exponent * z);  // w - w_star
    const Real sum = std::sqrt(w * (1 + w_star)) + std::sqrt(w_star * (1 + w));
    const Real push = lost > 0 ? -2 / k * std::asinh(lost / sum) : 0;
    const Real slope = k / gamma * std::sqrt(w_star / (1 + w_star));
    return {push, slope, rho * std::exp(z / gamma), w_star, 0, false};
}

/// With P = p_star/rho, D = P - theta (all divided by the density ahead), m = (gamma-1)/gamma D/P, the rise
/// dw of w is the positive root of Taub's adiabat
///     (1 - m) dw^2 + [2 (1 - m) w + 2 - m] dw = (1 + w) D (1 + theta/P),
/// and the compression r = rho_star/rho, the rise of energy and f_K follow without cancellation from
///     r - 1 = [gamma/(gamma-1) D - dw]/(w + dw),   de = r - 1 + D/(gamma-1),
///     sinh^2 f_K = D de/[h r h_star],
/// the shock's rapidity y_s from its mass flux rho sinh y_s, of square (p_star - p)/(h/rho -
/// h_star/rho_star):
///     sinh^2 y_s = D [P + (gamma-1) theta]/[(2-gamma) h D + (gamma-1) dw].
Side::Behind Side::shock(Real z, Real p_star) const {
    const Real P = p_star / rho;
    const Real D = z < 1 ? theta * std::expm1(z) : P - theta;
    const Real m = (gamma - 1) / gamma * (D / P), h = 1 + w;
    const Real linear = 2 * (1 - m) * w + 2 - m, constant = h * D * (1 + theta / P);
    const Real root = std::sqrt(linear * linear + 4 * (1 - m) * constant);
    const Real dw = 2 * constant / (linear + root);
    const Real w_star = w + dw;
    const Real r = gamma / (gamma - 1) * P / w_star;
    const Real de = (gamma / (gamma - 1) * D - dw) / w_star + D / (gamma - 1);
    const Real sinh2 = D * de / (h * r * (1 + w_star));

    // Derivatives with respect to ln p_star.
    const Real dm = (gamma - 1) / gamma * (theta / P);
    const Real dconstant = h * (P + theta * (theta / P));
    const Real ddw = (dconstant + dm * dw * (dw + 2 * w + 1)) / root;
    const Real dr = r * (1 - ddw / w_star);
    const Real dlog = P / D + (dr + P / (gamma - 1)) / de - dr / r - ddw / (1 + w_star);
    const Real slope = dlog / 2 * std::sqrt(sinh2 / (1 + sinh2));

    const Real speed2 = D * (P + (gamma - 1) * theta) / ((2 - gamma) * h * D + (gamma - 1) * dw);
    return {std::asinh(std::sqrt(sinh2)), slope, rho * r, w_star, std::sqrt(speed2), true};
}

/// dy, the rapidity that the gas has gained, is the root of
///     dy + artanh c_s(w) - artanh c_s(w_inside) = width,   arsinh sqrt(w_inside) = arsinh sqrt(w) - k/2 dy.
/// The left side is convex with a slope of 1 to gamma/2 + 1/2, so Newton's method from above converges.
Side::Inside Side::fan(Real width) const {
    const Real phi = std::asinh(std::sqrt(w));
    const auto sinh2 = [&](Real gained) {
        const Real sinh = std::sinh(std::max(Real{0}, phi - k / 2 * gained));
        return sinh * sinh;
    };
    const Real wanted = width - sound(w);
    Real gained = std::min(width, expansion());
    for (int step = 0; step < 20; ++step) {
        const Real inside = sinh2(gained);
        const Real excess = gained - sound(inside) - wanted;
        const Real change = excess / (1 + (gamma - 1) / 2 / (1 + (2 - gamma) * inside));
        gained = std::max(Real{0}, gained - change);
        if (std::abs(change) <= 1e-10L * gained) break;  // the error that is left is its square
    }
    // ln(c_inside/c) to the powers of rho and p: near the head of the fan as a small number.
    const Real lost = k / 2 * gained, inside = sinh2(gained);
    const Real half = std::sinh(lost / 2);
    const Real log_w = lost < std::min(phi, Real{1}) / 2
                           ? 2 * std::log1p(2 * half * half - std::sinh(lost) * std::sqrt((1 + w) / w))
                           : std::log(inside / w);
    return {rho * std::exp(log_w / (gamma - 1)), rapidity + gained, p * std::exp(gamma / (gamma - 1) * log_w),
            inside};
}

}  // namespace exact::relativistic_waves
