#pragma once
#include <limits>

#include "common/core/knobs.hpp"
#include "common/core/tile.hpp"

/// The Riemann problem between two particles, for eight pairs at a time: two uniform states of an ideal gas
/// meet, and what is wanted is the pressure P* and the velocity v* of the gas between the waves. The velocity
/// is that along the line from j (left) to i (right). A solver is a small type with star(left, right, gamma).
namespace sph {

/// A state beside the meeting point; rho, p > 0.
struct Beside {
    Tile rho, p, v;
};
/// Between the waves.
struct Star {
    Tile p, v;
};

namespace riemann_detail {
/// Where the gas meets a vacuum, no pressure is found; what stands for it is this part of the smaller one.
inline constexpr double least_pressure = 1e-9;
}  // namespace riemann_detail

/// The two outer waves as jumps at estimated speeds, with Roe's averages v~ and c~   (Toro
/// 2009, 10.36, 10.37; Batten et al. 1997, SIAM J. Sci. Comput. 18, 1553):
///     a_L = rho_L (v_L - min(v_L - c_L, v~ - c~)),   a_R = rho_R (max(v_R + c_R, v~ + c~) - v_R),
///     v* = (a_L v_L + a_R v_R + p_L - p_R)/(a_L + a_R),  p* = (a_R p_L + a_L p_R + a_L a_R (v_L - v_R))/(a_L
///     + a_R),
/// where p* < 0 next to nothing: no iteration, two square roots more.
struct HllcRiemann {
    Star star(const Beside& left, const Beside& right, double gamma) const {
        const Tile c2_L = gamma * left.p / left.rho, c2_R = gamma * right.p / right.rho;
        const Tile root_L = left.rho.sqrt(), root_R = right.rho.sqrt();
        const Tile share_L = root_L / (root_L + root_R), share_R = 1.0 - share_L, dv = right.v - left.v;
        const Tile v = share_L * left.v + share_R * right.v;
        const Tile c =
            (share_L * c2_L + share_R * c2_R + 0.5 * (gamma - 1) * share_L * share_R * dv * dv).sqrt();
        const Tile a_L = left.rho * (left.v - (left.v - c2_L.sqrt()).min(v - c));
        const Tile a_R = right.rho * ((right.v + c2_R.sqrt()).max(v + c) - right.v);
        const Tile scale = 1.0 / (a_L + a_R), least = riemann_detail::least_pressure * left.p.min(right.p);
        return {((a_R * left.p + a_L * right.p - a_L * a_R * dv) * scale).max(least),
                (a_L * left.v + a_R * right.v + left.p - right.p) * scale};
    }
};

namespace riemann_detail {
/// What a wave does: the velocity that the gas has gained when its pressure has become p, and the slope of
/// that, both for a wave that runs away from the meeting point with the gas pushed along.
struct Gain {
    Tile v, dv_dp;
};
/// A shock, or for p < p_0 the same formula read backwards:
///     v = (p - p_0)/W,   W^2 = rho_0 ((gamma + 1)/2 p + (gamma - 1)/2 p_0)   (Toro 2009, 4.37)
inline Gain shock(const Beside& at, const Tile& p, double gamma) {
    const Tile W2 = at.rho * (0.5 * (gamma + 1) * p + 0.5 * (gamma - 1) * at.p), W = W2.sqrt();
    return {(p - at.p) / W, (W2 + gamma * at.p * at.rho) / (2.0 * W2 * W)};
}
/// A fan: v = 2 c/(gamma - 1) [(p/p_0)^((gamma - 1)/(2 gamma)) - 1]   (Toro 2009, 4.26)
inline Gain fan(const Beside& at, const Tile& p, double gamma) {
    const double power = (gamma - 1) / (2 * gamma);
    const Tile ratio = p / at.p, c = (gamma * at.p / at.rho).sqrt(), grown = (power * ratio.log()).exp();
    return {2.0 / (gamma - 1) * c * (grown - 1.0), grown / (ratio * at.rho * c)};
}
/// Newton's iteration for the pressure at which both sides have one velocity, v_L - gain_L(p) = v_R +
/// gain_R(p), from that of HllcRiemann, or a tenth of the smaller pressure where that is more.
template <class GainOf>
Star iterate(const Beside& left, const Beside& right, double gamma, int iterations, const GainOf& gain) {
    const Tile smaller = left.p.min(right.p), least = least_pressure * smaller;
    Tile p = HllcRiemann{}.star(left, right, gamma).p.max(0.1 * smaller);
    Gain from_left{}, from_right{};
    for (int k = 0; k < iterations; ++k) {
        from_left = gain(left, p, gamma), from_right = gain(right, p, gamma);
        const Tile apart = (right.v + from_right.v) - (left.v - from_left.v);
        p = (p - apart / (from_left.dv_dp + from_right.dv_dp)).max(least);
    }
    from_left = gain(left, p, gamma), from_right = gain(right, p, gamma);
    return {p, 0.5 * ((left.v - from_left.v) + (right.v + from_right.v))};
}
}  // namespace riemann_detail

/// The exact solution, after `iterations` >= 1 of Newton's steps: shocks where the pressure rises, fans where
/// it falls. Costs a logarithm and an exponential per side and step.
struct ExactRiemann {
    double iterations = 5;
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"iterations", &ExactRiemann::iterations, {1, 40}, "steps of the Riemann solver"}};
    }
    // [exact]
    Star star(const Beside& left, const Beside& right, double gamma) const {
        using namespace riemann_detail;
        return iterate(
            left, right, gamma, static_cast<int>(iterations), [](const Beside& at, const Tile& p, double g) {
                const Gain as_shock = shock(at, p, g), as_fan = fan(at, p, g);
                const auto rises = p >= at.p;
                return Gain{rises.select(as_shock.v, as_fan.v), rises.select(as_shock.dv_dp, as_fan.dv_dp)};
            });
    }
    // [end]
};

/// Both waves as shocks: right for shocks, of third order in the strength for fans; no powers (Colella 1982,
/// SIAM J. Sci. Stat. Comput. 3, 76).
struct TwoShock {
    double iterations = 3;
    static constexpr auto knobs() {
        return std::tuple{Knob{"iterations", &TwoShock::iterations, {1, 40}, "steps of the Riemann solver"}};
    }
    Star star(const Beside& left, const Beside& right, double gamma) const {
        return riemann_detail::iterate(left, right, gamma, static_cast<int>(iterations),
                                       riemann_detail::shock);
    }
};

}  // namespace sph
