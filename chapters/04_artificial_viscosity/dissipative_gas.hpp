#pragma once
#include <algorithm>

#include "chapters/03_euler_sph/gas.hpp"
#include "chapters/04_artificial_viscosity/switches.hpp"

/// A gas that can pass shocks: chapter 3's resolutions and pressure, and a dissipation.
namespace sph {

/// What a gas dissipates with. Viscosity: viscosities.hpp, slopes.hpp; Conducts: conduction.hpp; Detector:
/// switches.hpp.
template <class Viscosity, class Conducts = NoConduction, class Detector = NoDetector>
struct Dissipation {
    Viscosity viscosity{};
    Conducts conduction{};
    Detector detector{};
};

/// Steps that conserve energy to rounding. Positions move half a step; all forces are computed there, from
/// predicted v and u; then v is moved on, and each pair's force heats by its work on the mean of the old and
/// the new velocity:
///     x' = x + dt/2 v,   v_1 = v + dt f(x', v', u'),   u_1 = u + dt (work on (v + v_1)/2),   x_1 = x + dt (v
///     + v_1)/2.
/// A pair's force changes the kinetic energy by exactly f . (v + v_1)/2 dt, so whatever density and h are,
/// the total energy stands still (Owen 2014, Int. J. Numer. Meth. Fluids 75, 749, for pairs split as here by
/// the terms P_i and P_j). Momentum too, since forces are antisymmetric. Second order in time; one evaluation
/// a step. Resolution must have a smoothing length for each particle.
template <class Resolution, class Scheme, class Boundary = Free>
class DissipativeGas {
    template <class V, class C, class D>
    static D detector_of(const Dissipation<V, C, D>&);
    using Detector = decltype(detector_of(std::declval<Scheme>()));

  public:
    using Kernel = typename Resolution::Kernel;
    static constexpr int d = Kernel::dimension;
    using P = ParticlesOf<d, Union<List<Position, Velocity, Acceleration, Mass, Density, Pressure, SoundSpeed,
                                        ThermalEnergy, Heating, MiddleVelocity, StepRate>,
                                   typename Resolution::Columns, typename Detector::Columns>>;

    P particles;

    DissipativeGas(std::size_t n, Resolution resolution, IdealGas state, Scheme scheme, Boundary boundary,
                   int threads)
        : particles{n},
          resolution_{std::move(resolution)},
          state_{state},
          scheme_{scheme},
          neighbours_{std::move(boundary), threads} {}

    /// Moves on to `end` in steps of `courant` over the largest SignalRate, none more than twice the one
    /// before. A step that would be longer than
    /// twice that in its middle, or leaves a thermal energy that is not positive, is done again with half the
    /// length, at most 20 times. Calls after_step(t) after each. Throws Unstable.
    template <class AfterStep>
    void advance(double& t, double end, double courant, AfterStep&& after_step);
    void advance(double& t, double end, double courant) {
        advance(t, end, courant, [](double) {});
    }

    /// Density, smoothing length, pressure and sound speed at the present positions.
    void resolve(double t);

    /// sum m (v^2/2 + u), less the work of the fixed ones on the moving ones: constant but for rounding.
    double energy() const {
        double sum = worked_;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const auto v = load<d>(particles, i, List<Velocity>{}).v;
            sum += particles.m[i] * (0.5 * dot(v, v) + particles.u[i]);
        }
        return sum;
    }
    /// sum m v of the moving particles, less what the fixed ones have pushed: constant but for rounding.
    Vector<d> momentum() const {
        Vector<d> sum = pushed_;
        for (std::size_t i = 0; i < particles.moving(); ++i)
            sum += particles.m[i] * load<d>(particles, i, List<Velocity>{}).v;
        return sum;
    }
    Counters& counters() { return neighbours_.counters(); }
    const IdealGas& state() const { return state_; }

  private:
    static constexpr int most_retries = 20;

    bool step(double t, double dt, double courant);
    void predict(double dt);
    void measure();
    void accelerate();
    void heat(double dt);
    template <class... Slope>
    void find_slopes(List<Slope...>) {
        if constexpr (sizeof...(Slope) > 0)
            sum_over_neighbours(particles, neighbours_, resolution_.smoothing(), Effects{Slope{}...});
    }
    double largest_rate() const {
        return *std::max_element(particles.step_rate.begin(), particles.step_rate.end());
    }

    Resolution resolution_;
    IdealGas state_;
    Scheme scheme_;
    Neighbours<d, Boundary> neighbours_;
    bool started_ = false;
    Columns<d> x_, v_, dv_dt_;  // where the step began, and the rates that it was predicted with
    Column u_, du_dt_, h_;
    double last_dt_ = std::numeric_limits<double>::infinity();
    Vector<d> pushed_{};  // what fixed particles would have gained, had they been free to move
    double worked_ = 0;
};

namespace dissipative_gas_detail {
/// The effects of a pass: `first`, and those of the viscosity and the conduction that there are.
template <template <class> class Viscous, class V, class... E>
auto with_viscosity(const V& viscosity, E... first) {
    if constexpr (std::is_same_v<V, NoViscosity>) {
        return Effects{first...};
    } else {
        return Effects{first..., Viscous<V>{viscosity}};
    }
}
template <class C, class... E>
auto with_conduction(const C& conduction, const Effects<E...>& effects) {
    if constexpr (std::is_same_v<C, NoConduction>) {
        return effects;
    } else {
        return std::apply([&](const auto&... e) { return Effects{e..., conduction}; }, effects.list);
    }
}
}  // namespace dissipative_gas_detail

template <class R, class S, class B>
void DissipativeGas<R, S, B>::resolve(double t) {
    P& p = particles;
    try {
        resolution_.resolve(p, neighbours_);
    } catch (const Unstable& failure) {
        throw Unstable{t, failure.particle, failure.quantity, failure.value};
    } catch (const std::invalid_argument&) {  // a position or h that is not a number: say when and whose
        require_physical(p, t, typename P::Names{});
        throw;
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.p[i] = state_.pressure(p.rho[i], p.u[i]);
        p.c_s[i] = state_.sound_speed(p.u[i]);
    }
}

/// Half a step ahead. u is kept from falling below a fifth: a prediction only, which no energy hangs on.
template <class R, class S, class B>
void DissipativeGas<R, S, B>::predict(double dt) {
    P& p = particles;
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.x[a][i] = x_[a][i] + dt / 2 * v_[a][i];
            p.v_mid[a][i] = v_[a][i] + dt / 2 * (i < p.moving() ? p.dv_dt[a][i] : 0);
        }
    }
    for (std::size_t i = 0; i < p.size(); ++i) p.u[i] = std::max(u_[i] + dt / 2 * p.du_dt[i], u_[i] / 5);
}

template <class R, class S, class B>
void DissipativeGas<R, S, B>::measure() {
    find_slopes(typename Detector::Slopes{});
    if constexpr (requires { scheme_.detector.measure(particles); }) scheme_.detector.measure(particles);
}

template <class R, class S, class B>
void DissipativeGas<R, S, B>::accelerate() {
    sum_over_neighbours(
        particles, neighbours_, resolution_.smoothing(),
        dissipative_gas_detail::with_viscosity<ViscousForce>(
            scheme_.viscosity, typename R::Force{}, SignalRate{std::max(0.5, strength(scheme_.viscosity))}));
}

/// v to the end of the step, and the heat of all work on its mean.
template <class R, class S, class B>
void DissipativeGas<R, S, B>::heat(double dt) {
    P& p = particles;
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t i = 0; i < p.size(); ++i)
            p.v[a][i] = v_[a][i] + (i < p.moving() ? dt / 2 * p.dv_dt[a][i] : 0);
    }
    sum_over_neighbours(p, neighbours_, resolution_.smoothing(),
                        dissipative_gas_detail::with_conduction(
                            scheme_.conduction, dissipative_gas_detail::with_viscosity<ViscousHeating>(
                                                    scheme_.viscosity, typename R::Heats{})));
}

/// One step; false if it must be shorter, and then all is as before.
template <class R, class S, class B>
bool DissipativeGas<R, S, B>::step(double t, double dt, double courant) {
    P& p = particles;
    x_ = p.x, v_ = p.v, u_ = p.u;
    dv_dt_ = p.dv_dt, du_dt_ = p.du_dt, h_ = p.h;
    predict(dt);
    resolve(t);
    measure();
    accelerate();
    bool good = dt * largest_rate() <= 2 * courant;
    if (good) {
        heat(dt);
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.u[i] = u_[i] + dt * p.du_dt[i];
            good = good && p.u[i] > 0;
        }
    }
    if (!good) {
        p.x = x_, p.v = v_, p.u = u_;
        p.dv_dt = dv_dt_, p.du_dt = du_dt_, p.h = h_;
        return false;
    }
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.x[a][i] = x_[a][i] + dt * p.v[a][i];
            p.v[a][i] = 2 * p.v[a][i] - v_[a][i];  // from the mean to the end
        }
        for (std::size_t i = p.moving(); i < p.size(); ++i) {
            pushed_[a] += dt * p.m[i] * p.dv_dt[a][i];
            worked_ += dt * p.m[i] * p.dv_dt[a][i] * p.v[a][i];
        }
    }
    if constexpr (requires { scheme_.detector.evolve(p, dt); }) scheme_.detector.evolve(p, dt);
    return true;
}

template <class R, class S, class B>
template <class AfterStep>
void DissipativeGas<R, S, B>::advance(double& t, double end, double courant, AfterStep&& after_step) {
    if (!started_) {
        step(t, 0, courant);  // the rates of the beginning
        started_ = true;
    }
    while (t < end) {
        double dt = std::min(courant / largest_rate(), 2 * last_dt_);
        const double left = end - t;
        if (left < 2 * dt) dt = left > dt ? left / 2 : left;
        bool done = false;
        for (int retry = 0; !done; ++retry) {
            require_time_step(t, dt);
            done = step(t, dt, courant);
            if (!done && retry == most_retries)
                throw Unstable{t, Unstable::no_particle, "the time step after 20 halvings", dt};
            if (!done) dt /= 2;
        }
        last_dt_ = dt;
        t = left == dt ? end : t + dt;
        ++neighbours_.counters().steps;
        Equations<Evolve<Position, Velocity>, Evolve<Velocity, Acceleration>,
                  Evolve<ThermalEnergy, Heating>>::require_physical(particles, t);
        after_step(t);
    }
    resolve(t);
}

}  // namespace sph
