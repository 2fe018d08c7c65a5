#pragma once
#include <algorithm>

#include "chapters/03_euler_sph/energy.hpp"
#include "chapters/03_euler_sph/forces.hpp"
#include "common/core/knobs.hpp"

/// Dissipation as a pair effect. A viscosity is a small type that gives the viscous pressure term Pi_ij of a
/// pair (Monaghan 2005, 8.2); what it does to velocity and to thermal energy is the same for all of them.
namespace sph {

/// The velocity in the middle of the step, with which viscosities are evaluated.
struct MiddleVelocity {
    static constexpr std::string_view name = "velocity in the middle of the step";
    template <class T, int d>
    struct In {
        Vec<T, d> v_mid{};
    };
};
/// The largest rate [1/time] at which anything passes between a particle and a neighbour.
struct StepRate {
    static constexpr std::string_view name = "rate that limits the time step";
    static constexpr bool maximum = true;
    template <class T, int>
    struct In {
        T step_rate{};
    };
};

/// The gradient factor that is common to both particles, (F(r, h_i) + F(r, h_j))/2 <= 0.
Tile mean_F(const auto& pair) {
    return 0.5 * (F_i(pair) + F_j(pair));
}
/// v_ij . x_ij/r of the middle velocities: negative where the particles approach; 0 for a particle and
/// itself.
template <int d>
Tile closing_speed(const Vec<Tile, d>& v_ij, const auto& pair) {
    return dot(v_ij, pair.x_ij) / pair.r.max(std::numeric_limits<double>::min());
}

// [force]
/// dv_i/dt = - sum_j m_j Pi_ij grad_i W_ij, with the mean of both kernels   (8.2)
/// Viscosity: Pi_ij = viscosity.pressure(i, j, pair) [pressure/density^2], symmetric in i and j.
template <class Viscosity>
struct ViscousForce {
    Viscosity viscosity;
    using Reads = typename Viscosity::Reads;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = j.m * viscosity.pressure(i, j, pair) * mean_F(pair);
        sum.dv_dt -= weight * pair.x_ij;
    }
};
// [end]

/// du_i/dt = 1/2 sum_j m_j Pi_ij v_ij . grad_i W_ij   (8.13, where a sum over i is printed that does not
/// belong there; 8.16 is right): the work of the viscous force, half to each particle.
template <class Viscosity>
struct ViscousHeating {
    Viscosity viscosity;
    using Reads = Union<List<Velocity>, typename Viscosity::Reads>;
    using ReadsJ = List<Mass>;
    using Adds = List<Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = 0.5 * j.m * viscosity.pressure(i, j, pair) * mean_F(pair);
        sum.du_dt += weight * dot(i.v - j.v, pair.x_ij);
    }
};

/// How strong a viscosity is, as the K of (8.11): alpha/2 of (8.10); 0.5, the usual, where it has neither.
template <class Viscosity>
double strength(const Viscosity& viscosity) {
    if constexpr (requires { viscosity.K; }) {
        return viscosity.K;
    } else if constexpr (requires { viscosity.alpha; }) {
        return viscosity.alpha / 2;
    } else if constexpr (requires { viscosity.signal; }) {
        return strength(viscosity.signal);
    } else if constexpr (requires { viscosity.viscosity; }) {
        return strength(viscosity.viscosity);
    } else {
        return 0.5;
    }
}

/// The fastest signal of a pair over its smaller smoothing length, and the speed at which the distance
/// changes over the distance: max_j of [K (c_i + c_j) + 3 w_ij] / min(h_i, h_j) and |v_ij . x_ij|/r^2, where
/// w = max(-v_ij . x_ij/r, 0). The 3 is 1 for the motion and beta/2 = 2 for the viscosity. K >= 0.5 is the
/// viscosity's: it spreads velocity at K (c_i + c_j).
struct SignalRate {
    double K = 0.5;
    using Reads = List<MiddleVelocity, SoundSpeed, SmoothingLength>;
    using Adds = List<StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile r = pair.r.max(std::numeric_limits<double>::min());
        const Tile along = closing_speed(i.v_mid - j.v_mid, pair);
        const Tile signal = (K * (i.c_s + j.c_s) + 3.0 * (-along).max(0.0)) / j.h.min(i.h);
        const Tile rate = signal.max(along.abs() / r);
        sum.step_rate = sum.step_rate.max((mean_F(pair) < 0).select(rate, 0.0));
    }
};

}  // namespace sph
