#pragma once
#include "chapters/04_artificial_viscosity/dissipation.hpp"
#include "chapters/07_godunov_sph/convolved.hpp"
#include "chapters/07_godunov_sph/sides_of_face.hpp"

/// The force of Godunov SPH as a pair effect, and what limits its steps.
namespace sph {

/// Force and heat of a pair through the solution P*, v* of a Riemann problem between its particles (Inutsuka
/// 2002, 83 and 85):
///     dv_i/dt = - sum_j m_j P* [V2(h_i) grad_i W(x_ij, sqrt2 h_i) + V2(h_j) grad_i W(x_ij, sqrt2 h_j)],
///     du_i/dt = - sum_j m_j P* (v* - v_i) . [...],
/// v_i that of the step's beginning. The paper has the velocity of its middle, v_i + dt/2 dv_i/dt, there;
/// what is missing, - dt/2 (dv_i/dt)^2, is the same for all pairs, and the step adds it (godunov_gas.hpp).
/// Sides: sides_of_face.hpp; Volumes: volumes.hpp; Solver: riemann.hpp.
template <class Sides, class Volumes, class Solver, class Kernel>
struct RiemannForce {
    Sides sides;
    Volumes volumes;
    Solver solver;
    StepOfSides step;
    Kernel kernel{};

    using Reads = Union<List<Velocity>, typename Sides::Reads, typename Volumes::Reads>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration, Heating>;
    // [force]
    template <class I, class J, class Pair, class Sum>
    void add(const I& i, const J& j, const Pair& pair, Sum& sum) const {
        constexpr double close = 1e-9;  // in h: a particle and itself
        const Tile r = pair.r.max(close * i.h);
        const auto n = (1.0 / r) * pair.x_ij;
        const Between face = volumes.face(i, j, n, r, kernel);
        const TwoSides meeting = sides.meet(i, j, n, r, face.s, step);
        const Star star = solver.star(meeting.left, meeting.right, step.gamma);
        const Tile push = j.m * star.p * face.area;
        sum.dv_dt -= push * n;
        sum.du_dt -= push * (star.v - dot(i.v, n));
    }
    // [end]
};

/// The paper's limit of the step, c_s over the spacing (m/rho)^(1/d)   (Inutsuka 2002, 89). It knows nothing
/// of velocities: cold streams that collide have no limit.
struct SoundRate {
    using ReadsI = List<Mass, Density, SoundSpeed>;
    using Writes = List<StepRate>;
    template <class I, class Sum, class Out>
    void finish(const I& i, const Sum&, Out& out) const {
        constexpr int d = Out::dimension;
        out.step_rate = i.c_s / std::pow(i.m / i.rho, 1.0 / d);
    }
};
/// The largest of [share (c_i + c_j) + closing max(-w, 0)]/min(h_i, h_j) over the neighbours, w the velocity
/// at which they recede from each other, and of |w|/(2 r), so that none passes another in a step. With C =
/// 0.45 and the share 0.3 sound goes 0.75 of h in a step. In the plane and in space particles do pass each
/// other, and those that are nearer than `nearest` h may do so in a step, since no force keeps them apart
/// there; nor may a particle that comes near its own image in a wall stop the clock.
struct ClosingRate {
    double share = 0.3, closing = 1;
    static constexpr double nearest = 0.1;
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"sound-share", &ClosingRate::share, {0.05, 5}, "part of both speeds of sound in the rate"},
            Knob{"closing-share", &ClosingRate::closing, {0, 10}, "part of the closing speed in the rate"}};
    }
    using Reads = List<Velocity, SoundSpeed, SmoothingLength>;
    using Adds = List<StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile w = closing_speed(i.v - j.v, pair);
        const Tile signal = (share * (i.c_s + j.c_s) + closing * (-w).max(0.0)) / j.h.min(i.h);
        constexpr bool on_a_line = std::decay_t<decltype(pair.x_ij)>::size() == 1;
        const Tile least = on_a_line ? Tile{std::numeric_limits<double>::min()} : nearest * j.h.min(i.h);
        const Tile rate = signal.max(0.5 * w.abs() / pair.r.max(least));
        sum.step_rate = sum.step_rate.max((mean_F(pair) < 0).select(rate, 0.0));
    }
};

}  // namespace sph
