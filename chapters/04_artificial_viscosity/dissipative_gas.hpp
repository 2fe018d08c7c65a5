#pragma once
#include "chapters/03_euler_sph/gas.hpp"
#include "chapters/04_artificial_viscosity/switches.hpp"

/// A gas that can pass shocks: chapter 3's resolutions and pressure, and a dissipation.
namespace sph {

/// What a gas dissipates with. Viscosity: viscosities.hpp, reconstruction.hpp; Conducts: conduction.hpp;
/// Detector: switches.hpp.
template <class Viscosity, class Conducts = NoConduction, class Detector = NoDetector>
struct Dissipation {
    Viscosity viscosity{};
    Conducts conduction{};
    Detector detector{};

    using Columns = typename Detector::Columns;
    using Slopes = typename Detector::Slopes;
    static auto parts(auto& self) { return std::tie(self.viscosity, self.conduction, self.detector); }

    /// The passes of forces and of heats: with what the gas has anyway.
    template <class... E>
    auto forces(const E&... given) const {
        if constexpr (viscous) {
            return Effects{given..., ViscousForce<Viscosity>{viscosity}};
        } else {
            return Effects{given...};
        }
    }
    template <class... E>
    auto heats(const E&... given) const {
        if constexpr (viscous && conducts) {
            return Effects{given..., ViscousHeating<Viscosity>{viscosity}, conduction};
        } else if constexpr (viscous) {
            return Effects{given..., ViscousHeating<Viscosity>{viscosity}};
        } else if constexpr (conducts) {
            return Effects{given..., conduction};
        } else {
            return Effects{given...};
        }
    }
    /// K of SignalRate.
    double largest_strength() const { return std::max(0.5, strength(viscosity)); }

  private:
    static constexpr bool viscous = !std::is_same_v<Viscosity, NoViscosity>;
    static constexpr bool conducts = !std::is_same_v<Conducts, NoConduction>;
};

/// A gas whose steps its particles' StepRate limits: `courant` over the largest one, and none more than twice
/// the one before. Who derives from it makes the steps; a step that fails is undone here, for which the
/// columns Saved are kept.
template <class Resolution, class Boundary, class More, class Saved>
class RateLimited : public Smoothed<Simulation, Resolution, Boundary, Union<List<StepRate>, More>> {
    using Base = Smoothed<Simulation, Resolution, Boundary, Union<List<StepRate>, More>>;

  public:
    static constexpr int d = Base::d;
    using Base::particles;

    double longest_step() final {
        if (!has_rates_) first_rates(time_);
        has_rates_ = true;
        return std::min(courant_ / largest_rate(), 2 * last_dt_);
    }
    bool step(double& t, double dt) final {
        copy_columns(particles, before_);
        if (!advance(t, dt)) {
            copy_columns(before_, particles);
            return false;
        }
        last_dt_ = dt;
        time_ = t += dt;
        return true;
    }
    void restart() final { has_rates_ = false; }

  protected:
    RateLimited(std::size_t n, Resolution resolution, Boundary boundary, double courant, int threads)
        : Base{n, std::move(resolution), std::move(boundary), threads}, courant_{courant} {}

    /// Computes the rates that the first step is predicted with, at the present state.
    virtual void first_rates(double t) = 0;
    /// One step of dt >= 0 from before_, which is the present state too; false if it must be shorter.
    virtual bool advance(double t, double dt) = 0;

    /// sum m v of the free particles and sum m (v^2/2 + u) of all, less what the held ones have given.
    Totals<d> thermal_totals() const {
        const auto& p = particles;
        Totals<d> sum = given_;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto v = load<d>(p, i, List<Velocity>{}).v;
            sum.mass += p.m[i];
            sum.energy += p.m[i] * (0.5 * dot(v, v) + p.u[i]);
        }
        p.groups.for_each_free(p.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                sum.momentum += p.m[i] * load<d>(p, i, List<Velocity>{}).v;
        });
        return sum;
    }
    double largest_rate() const {
        return *std::max_element(particles.step_rate.begin(), particles.step_rate.end());
    }
    /// Whether the present rates allow less than half of dt.
    bool too_long(double dt) const { return !(dt * largest_rate() <= 2 * courant_); }

    ParticlesOf<d, Saved> before_;  // where the step began, and the rates that it is predicted with
    Totals<d> given_;               // what held particles would have gained, had they been free
    double time_ = 0;

  private:
    double courant_;
    bool has_rates_ = false;
    double last_dt_ = std::numeric_limits<double>::infinity();
};

namespace dissipative_gas_detail {
template <class Scheme>
using More =
    Union<List<Acceleration, SoundSpeed, ThermalEnergy, Heating, MiddleVelocity>, typename Scheme::Columns>;
using Saved = List<Position, Velocity, Acceleration, ThermalEnergy, Heating, SmoothingLength>;
}  // namespace dissipative_gas_detail

/// Steps that conserve energy to rounding. Positions move half a step; all forces are computed there, from
/// predicted v and u; then v is moved on, and each pair's force heats by its work on the mean of the old and
/// the new velocity:
///     x' = x + dt/2 v,   v_1 = v + dt f(x', v', u'),   u_1 = u + dt (work on (v + v_1)/2),
///     x_1 = x + dt (v + v_1)/2.
/// A pair's force changes the kinetic energy by exactly f . (v + v_1)/2 dt, so whatever density and h are,
/// the total energy stands still (Owen 2014, Int. J. Numer. Meth. Fluids 75, 749, for pairs split as here by
/// the terms P_i and P_j). Momentum too, since forces are antisymmetric. Second order in time; one evaluation
/// a step. A step is done again with half its length where its middle would allow less than half of it, or
/// where it leaves a thermal energy that is not positive. Resolution must have a smoothing length for each
/// particle.
template <class Resolution, class Scheme, class Boundary = Free>
class DissipativeGas : public RateLimited<Resolution, Boundary, dissipative_gas_detail::More<Scheme>,
                                          dissipative_gas_detail::Saved> {
    using Base = RateLimited<Resolution, Boundary, dissipative_gas_detail::More<Scheme>,
                             dissipative_gas_detail::Saved>;

  public:
    static constexpr int d = Base::d;
    using Base::particles;

    DissipativeGas(std::size_t n, Resolution resolution, ThermalState state, Scheme scheme, Boundary boundary,
                   double courant, int threads)
        : Base{n, std::move(resolution), std::move(boundary), courant, threads},
          state_{std::move(state)},
          scheme_{std::move(scheme)} {}

    void start(double t) override {
        this->time_ = t;
        this->resolution_.start(particles);
        state_.set_energy(particles.rho, particles.p, particles.u);
        if constexpr (requires { scheme_.detector.start(particles); }) scheme_.detector.start(particles);
    }
    void resolve(double t) override {
        this->find_density(t);
        state_.set_pressure(particles.rho, particles.u, particles.p);
        state_.set_sound_speed(particles.rho, particles.u, particles.c_s);
    }
    Totals<d> totals() const override { return this->thermal_totals(); }

  private:
    void first_rates(double t) override {
        copy_columns(particles, this->before_);
        advance(t, 0);
    }
    bool advance(double t, double dt) override;
    void predict(double dt);
    bool heat(double dt);
    void finish(double dt);

    ThermalState state_;
    Scheme scheme_;
};

/// Half a step ahead. u is kept from falling below a fifth: a prediction only, which no energy hangs on.
template <class R, class S, class B>
void DissipativeGas<R, S, B>::predict(double dt) {
    auto& p = particles;
    const auto& before = this->before_;
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t i = 0; i < p.size(); ++i) p.x[a][i] = before.x[a][i] + dt / 2 * before.v[a][i];
        p.v_mid[a] = before.v[a];
        p.groups.for_each_free(p.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) p.v_mid[a][i] += dt / 2 * p.dv_dt[a][i];
        });
    }
    for (std::size_t i = 0; i < p.size(); ++i)
        p.u[i] = std::max(before.u[i] + dt / 2 * p.du_dt[i], before.u[i] / 5);
}

/// v in the mean of the step, and the heat of all work on it; false if it leaves an energy that is not > 0.
template <class R, class S, class B>
bool DissipativeGas<R, S, B>::heat(double dt) {
    auto& p = particles;
    const auto& before = this->before_;
    for (std::size_t a = 0; a < d; ++a) {
        p.v[a] = before.v[a];
        p.groups.for_each_free(p.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) p.v[a][i] += dt / 2 * p.dv_dt[a][i];
        });
    }
    this->sum(scheme_.heats(typename R::Heats{}));
    for (std::size_t i = 0; i < p.size(); ++i) p.u[i] = before.u[i] + dt * p.du_dt[i];
    return std::all_of(p.u.begin(), p.u.end(), [](double u) { return u > 0; });
}

/// x, and v from the mean to the end.
template <class R, class S, class B>
void DissipativeGas<R, S, B>::finish(double dt) {
    auto& p = particles;
    const auto& before = this->before_;
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.x[a][i] = before.x[a][i] + dt * p.v[a][i];
            p.v[a][i] = 2 * p.v[a][i] - before.v[a][i];
        }
        for (const Group& group : p.groups.held()) {
            for (std::size_t i = group.begin; i < group.end; ++i) {
                this->given_.momentum[a] += dt * p.m[i] * p.dv_dt[a][i];
                this->given_.energy += dt * p.m[i] * p.dv_dt[a][i] * p.v[a][i];
            }
        }
    }
    if constexpr (requires { scheme_.detector.evolve(p, dt); }) scheme_.detector.evolve(p, dt);
}

// [advance]
template <class R, class S, class B>
bool DissipativeGas<R, S, B>::advance(double t, double dt) {
    predict(dt);
    resolve(t);
    this->sum(typename S::Slopes{});
    if constexpr (requires { scheme_.detector.measure(particles); }) scheme_.detector.measure(particles);
    this->sum(scheme_.forces(typename R::Force{}, SignalRate{scheme_.largest_strength()}));
    if (this->too_long(dt) || !heat(dt)) return false;
    finish(dt);
    this->require_physical_columns(List<Position, Velocity, ThermalEnergy>{}, t + dt);
    return true;
}
// [end]

}  // namespace sph
