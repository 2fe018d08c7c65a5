#pragma once

#include <numbers>

#include "common/exact/landau_khalatnikov.hpp"

namespace exact {

/// Landau's slab: an ideal fluid without baryons, p = eps/3, at rest in |x| <= l at t = 0, with the vacuum
/// outside. On the side x > 0 there are, from outside to inside,
///     the vacuum from the edge l + t on;
///     a simple wave, y = -zeta/c_s, (x - l)/t = (tanh y - c_s)/(1 - c_s tanh y), with c_s = 1/sqrt3;
///     until t = l/c_s the fluid at rest in x <= l - c_s t, later the flow of Khalatnikov, which meets the
///     simple wave at a weak discontinuity;
/// y is the rapidity, v = tanh y the velocity, zeta = ln(T/T0), eps/eps0 = e^(4 zeta), s/s0 = e^(3 zeta).
/// Source: Chen (2017), eqs 209-214, where 214 has x for x - l; Khalatnikov (1954); Wong et al., Phys. Rev. C
/// 90 (2014) 064907. The middle: landau_khalatnikov.hpp.
///
/// Units: l, c, and eps0, s0, T0 of the fluid at rest, each of which is 1 here. The entropy and the energy of
/// the whole slab, the integrals of s_star = lorentz s and of T00 = eps (4 lorentz^2 - 1)/3, are then 2.
///
/// Accuracy against 40 digits, for the very doubles t and x, up to the edge: measured 5e-15 relative, where
/// rapidity and velocity go to zero at the centre too; beside the fluid at rest these have an absolute error
/// of 1e-16. Beside the edge rounding of x counts, which moves eps by 2/sqrt3 dx/(1 + t - x).
/// Cost: 2 to 4 microseconds, and as much for each place in Khalatnikov's flow, 0.1 microseconds elsewhere.
class LandauSlab {
  public:
    static constexpr double largest_time = khalatnikov::largest_time;
    static constexpr double meeting_time = std::numbers::sqrt3;  ///< of the two simple waves, l/c_s

    /// t in 0..largest_time. Throws std::domain_error, which names the value, outside this range.
    explicit LandauSlab(double t);

    struct State {
        double s_star, eps, rapidity, temperature, velocity, lorentz;
    };

    // The two functions that follow take any finite x, and throw std::domain_error, which names the value,
    // for other x.

    /// The state at x. The vacuum begins at |x| = 1 + t, for t = 0 beyond it, with s_star = eps =
    /// temperature = 0 and, as the fluid has no velocity there, rapidity = velocity = 0 and lorentz = 1.
    State at(double x) const;
    /// The integral of s_star from -infinity to x, which rises from 0 to 2 and moves with the fluid.
    double entropy_left_of(double x) const;

    double time() const { return t_; }
    double edge() const { return 1 + t_; }  ///< where the vacuum begins
    /// Where the simple wave begins: at the fluid at rest, and for t > sqrt3 at the flow of Khalatnikov.
    double matching() const { return matching_; }

  private:
    enum class Zone { middle, at_rest, wave, vacuum };

    bool waves_have_met() const { return t_ > meeting_time; }
    // Of the side x > 0, at the distance x from the centre.
    Zone zone(double distance) const;
    khalatnikov::State middle(double distance) const;
    State right_side(double distance) const;
    double entropy_beyond(double distance) const;

    double t_, matching_;
    // Of Khalatnikov's flow: its ends, and artanh(x/t) of the outer one.
    khalatnikov::State centre_{0, 0}, outer_{0, 0};
    double outer_eta_ = 0;
};

}  // namespace exact
