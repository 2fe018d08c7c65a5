#pragma once
#include "chapters/04_artificial_viscosity/dissipative_gas.hpp"
#include "chapters/08_landau_model/baryon_state.hpp"
#include "chapters/08_landau_model/relativistic_dissipation.hpp"

/// A relativistic gas of baryons that can pass shocks.
namespace sph {

/// A way to dissipate: the gradients that it needs, and what pairs exchange, as lists of effects.
template <class Gradients, class... Exchange>
struct ExchangeScheme {
    using Slopes = Gradients;
    std::tuple<Exchange...> exchange{};
    static auto parts(auto& self) {
        return std::apply([](auto&... one) { return std::tie(one...); }, self.exchange);
    }
};
// [schemes]
using NoExchange = ExchangeScheme<List<>>;
using ChowMonaghanExchange = ExchangeScheme<List<>, ChowMonaghan>;
using ReconstructedScheme =
    ExchangeScheme<List<RapidityGradient, LabPressureGradient>, ReconstructedExchange, ContactConduction>;
// [end]

namespace relativistic_gas_detail {
template <class Scheme>
using More = Union<List<MomentumPerCharge, MomentumRate, EnergyPerBaryon, EnergyRate, Density, SoundSpeed,
                        ThermalEnergy, Enthalpy, Rapidity>,
                   typename Scheme::Slopes>;
using Saved = List<Position, Velocity, Pressure, MomentumPerCharge, MomentumRate, EnergyPerBaryon, EnergyRate,
                   SmoothingLength>;
}  // namespace relativistic_gas_detail

/// q and E evolve, h and n* = sum m W are solved as in chapter 3, v and P recovered (baryon_state.hpp). Steps
/// of second order with one evaluation of the forces, in the middle:
///     x' = x + dt/2 v,  q', E' with the rates of the last middle;
///     x += dt v',  q += dt dq/dt',  E += dt dE/dt'.
/// Totals of q and E stand still to rounding. A step is done again with half its length where its middle
/// would allow less than half of it, or where it leaves a particle without thermal energy. In one dimension.
template <class Resolution, class Scheme, class Boundary = Free>
class RelativisticGas : public RateLimited<Resolution, Boundary, relativistic_gas_detail::More<Scheme>,
                                           relativistic_gas_detail::Saved> {
    using Base = RateLimited<Resolution, Boundary, relativistic_gas_detail::More<Scheme>,
                             relativistic_gas_detail::Saved>;

  public:
    using Base::particles;
    static_assert(Base::d == 1, "velocities are recovered along one axis");

    RelativisticGas(std::size_t n, Resolution resolution, IdealGas state, Scheme scheme, Boundary boundary,
                    double courant, int threads)
        : Base{n, std::move(resolution), std::move(boundary), courant, threads},
          gamma_{state.gamma},
          scheme_{std::move(scheme)} {}

    void start(double t) override {
        auto& p = particles;
        this->time_ = t;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double v = p.v[0][i];
            const MomentumEnergy given = momentum_energy(p.rho[i], v, p.p[i], gamma_);
            p.n_star[i] = p.rho[i] / std::sqrt((1 - v) * (1 + v));
            p.q[0][i] = given.q, p.E[i] = given.E;
        }
        this->resolution_.start(p);
    }
    void resolve(double t) override {
        this->find_density(t);
        const std::size_t wrong = recover_all();
        if (wrong < particles.size())
            throw Unstable{t, wrong, std::string{EnergyPerBaryon::name}, particles.E[wrong]};
    }
    /// sum m E and sum m q of the free particles, less what the held ones have given.
    Totals<1> totals() const override {
        const auto& p = particles;
        Totals<1> sum = this->given_;
        p.groups.for_each_free(p.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                sum.mass += p.m[i];
                sum.momentum[0] += p.m[i] * p.q[0][i];
                sum.energy += p.m[i] * p.E[i];
            }
        });
        return sum;
    }

  private:
    void first_rates(double t) override {
        resolve(t);
        sum_rates();
    }
    bool advance(double t, double dt) override;
    std::size_t recover_all();
    void sum_rates();
    void move(double dt);

    double gamma_;
    Scheme scheme_;
};

/// The first particle that no state belongs to; how many there are if all are sound.
template <class R, class S, class B>
std::size_t RelativisticGas<R, S, B>::recover_all() {
    auto& p = particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const BaryonState state = recover_baryons(p.q[0][i], p.E[i], p.n_star[i], gamma_, p.p[i]);
        if (!state.sound) return i;
        p.v[0][i] = state.v, p.y[i] = std::asinh(state.U), p.rho[i] = p.n_star[i] / std::cosh(p.y[i]);
        p.p[i] = state.p, p.u[i] = state.u, p.c_s[i] = state.c_s, p.h_enthalpy[i] = state.h;
    }
    return p.size();
}

template <class R, class S, class B>
void RelativisticGas<R, S, B>::sum_rates() {
    this->sum(typename S::Slopes{});
    std::apply(
        [&](const auto&... exchange) {
            this->sum(Effects{typename R::Force{}, GradHWork{}, exchange..., LabSignalRate{}});
        },
        scheme_.exchange);
}

/// From where the step began, with the present velocities and rates.
template <class R, class S, class B>
void RelativisticGas<R, S, B>::move(double dt) {
    auto& p = particles;
    const auto& before = this->before_;
    for (std::size_t i = 0; i < p.size(); ++i) p.x[0][i] = before.x[0][i] + dt * p.v[0][i];
    p.groups.for_each_free(p.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            p.q[0][i] = before.q[0][i] + dt * p.dq_dt[0][i];
            p.E[i] = before.E[i] + dt * p.dE_dt[i];
        }
    });
}

template <class R, class S, class B>
bool RelativisticGas<R, S, B>::advance(double t, double dt) {
    auto& p = particles;
    move(dt / 2);
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(p.x[0].begin(), p.x[0].end(), finite)) return false;
    this->find_density(t);
    if (recover_all() < p.size()) return false;
    sum_rates();
    if (this->too_long(dt)) return false;
    move(dt);
    if (recover_all() < p.size()) return false;
    for (const Group& group : p.groups.held()) {
        for (std::size_t i = group.begin; i < group.end; ++i) {
            this->given_.momentum[0] += dt * p.m[i] * p.dq_dt[0][i];
            this->given_.energy += dt * p.m[i] * p.dE_dt[i];
        }
    }
    return true;
}

}  // namespace sph
