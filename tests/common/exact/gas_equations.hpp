#pragma once
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "tests/common/exact/derivatives.hpp"

/// Whether exact solutions of gas dynamics obey the equations of motion.
namespace gas_equations {

/// The sum of some terms over the sum of their magnitudes: how well they cancel.
inline double cancellation(double a, double b, double c) {
    const double size = std::fabs(a) + std::fabs(b) + std::fabs(c);
    return size > 0 ? std::fabs(a + b + c) / size : 0;
}

/// The largest residual of continuity, momentum and energy,
///     rho_t + v rho_r + rho div v = 0,   v_t + v v_r + p_r/rho = 0,   u_t + v u_r + (p/rho) div v = 0,
///     div v = v_r + (d-1) v/r,
/// at r and t, by differences over up to 4 dr and 4 dt; `solution.at(r, t)` has the members rho, v, p, u.
inline double residual(const auto& solution, int dimension, double r, double t, double dr, double dt) {
    using finite_difference::derivatives;
    const auto in_r = [&](auto member) {
        return derivatives(dr, [&](double s) { return solution.at(r + s, t).*member; }).first;
    };
    const auto in_t = [&](auto member) {
        return derivatives(dt, [&](double s) { return solution.at(r, t + s).*member; }).first;
    };
    const auto state = solution.at(r, t);
    using State = std::remove_const_t<decltype(state)>;
    const auto [rho, v, p, u] = state;
    const double div_v = in_r(&State::v) + (dimension - 1) * v / r;
    return std::max({cancellation(in_t(&State::rho), v * in_r(&State::rho), rho * div_v),
                     cancellation(in_t(&State::v), v * in_r(&State::v), rho > 0 ? in_r(&State::p) / rho : 0),
                     cancellation(in_t(&State::u), v * in_r(&State::u), rho > 0 ? p / rho * div_v : 0)});
}

/// Fluxes of mass, momentum and energy in the frame of a shock.
struct Fluxes {
    double mass, momentum, energy;
};
inline Fluxes fluxes(const auto& state, double shock_speed) {
    const auto [rho, v, p, u] = state;
    const double w = v - shock_speed;
    return {rho * w, rho * w * w + p, w * (rho * (u + w * w / 2) + p)};
}

/// How far the states on both sides of a shock are from its jump conditions: relative.
inline double jump_error(const auto& ahead, const auto& behind, double shock_speed) {
    const Fluxes a = fluxes(ahead, shock_speed), b = fluxes(behind, shock_speed);
    return std::max({std::fabs(a.mass / b.mass - 1), std::fabs(a.momentum / b.momentum - 1),
                     std::fabs(a.energy / b.energy - 1)});
}

}  // namespace gas_equations
