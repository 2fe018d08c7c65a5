#pragma once
#include <cmath>
#include <limits>
#include <stdexcept>

/// From what evolves to what moves: the velocity of a particle whose momentum is known.
namespace sph {

/// What a recovery of the velocity gives: U = lorentz v, and how many evaluations of w it took.
struct Recovered {
    double U = 0;
    int evaluations = 0;
    double lorentz() const { return std::sqrt(1 + U * U); }
    double velocity() const { return U / lorentz(); }
};

/// The root U of  f(U) = U w(n_star/sqrt(1 + U^2)) - q = 0,  the momentum per charge of (220), (237) with
/// w = (eps + P)/n and n = n_star/lorentz. f increases, U f'/(U w) = 1 - c_s^2 v^2 being above 1 - c_s^2, so
/// there is one root; it is the four-velocity U, not v, that is looked for, since v near 1 has lost the
/// digits of 1 - v. Newton's method from `guess` (0: from q/w(n_star)), in a bracket that closes around it;
/// it ends with a relative step below 1e-9, whose square is what is left. q: any finite number; n_star > 0;
/// Fluid: fluids.hpp. Throws std::domain_error for others. Cost: 3 to 7 evaluations of w from lorentz 1 to
/// 1e6, 2 with a guess of the step before; none for q = 0.
template <class Fluid>
Recovered recover(double q, double n_star, const Fluid& fluid, double guess = 0) {
    if (!std::isfinite(q)) throw std::domain_error{"momentum per charge is not finite"};
    if (!(n_star > 0 && std::isfinite(n_star))) throw std::domain_error{"density is not positive and finite"};
    if (q == 0) return {};
    constexpr int most = 200;
    constexpr double close = 1e-9;
    const double wanted = std::abs(q);
    double low = 0, high = std::numeric_limits<double>::infinity();
    Recovered result{std::abs(guess), 0};
    if (!(result.U > 0 && q * guess > 0)) result = {wanted / fluid.enthalpy(n_star), 1};
    // [root]
    for (; result.evaluations < most; ++result.evaluations) {
        const double U = result.U, lorentz = result.lorentz(), n = n_star / lorentz;
        const double found = U * fluid.enthalpy(n), v = U / lorentz;
        (found < wanted ? low : high) = U;
        const double step = (wanted / found - 1) / (1 - fluid.sound_speed_squared(n) * v * v);
        double next = U * (1 + step);
        const bool found_it = std::abs(step) < close;
        if (!found_it && !(next > low && next < high)) next = std::isinf(high) ? 2 * U : 0.5 * (low + high);
        result.U = next;
        if (found_it || next == U) break;
    }
    // [end]
    result.U = std::copysign(result.U, q);
    return result;
}

/// The same by iterating v <- q/(lorentz(v) w(n_star/lorentz(v))), which is what one writes first. Where it
/// leaves |v| < 1 it has failed: NaN. Shown to be compared, not to be used.
template <class Fluid>
Recovered recover_by_fixed_point(double q, double n_star, const Fluid& fluid) {
    double v = 0, last = 1;
    Recovered result;
    while (std::abs(v - last) > 1e-15 && result.evaluations < 200) {
        last = v;
        const double lorentz = 1 / std::sqrt((1 - v) * (1 + v));
        v = q / (lorentz * fluid.enthalpy(n_star / lorentz));
        ++result.evaluations;
    }
    result.U = v / std::sqrt((1 - v) * (1 + v));
    return result;
}

/// The same by Newton's method on v, from v = 0 and without a bracket.
template <class Fluid>
Recovered recover_by_newton(double q, double n_star, const Fluid& fluid) {
    double v = 0, step = 1;
    Recovered result;
    while (std::abs(step) > 1e-15 && result.evaluations < 200) {
        const double lorentz = 1 / std::sqrt((1 - v) * (1 + v)), n = n_star / lorentz;
        const double w = fluid.enthalpy(n), slope = 1 - fluid.sound_speed_squared(n) * v * v;
        step = (q - lorentz * v * w) / (w * lorentz * lorentz * lorentz * slope);
        v += step;
        ++result.evaluations;
    }
    result.U = v / std::sqrt((1 - v) * (1 + v));
    return result;
}

}  // namespace sph
