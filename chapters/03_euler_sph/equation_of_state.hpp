#pragma once
#include <cmath>
#include <memory>

#include "common/core/vec.hpp"

/// Equations of state, as small types. A barotropic one has, for rho > 0,
///     pressure(rho), sound_speed(rho), energy(rho) = integral of P/rho^2 d rho,
/// the energy being what compression without dissipation has stored, by mass (Monaghan 2005, 5.5). Where the
/// thermal energy u [energy by mass] is a quantity of its own, there are
///     pressure(rho, u), energy(rho, p), sound_speed(rho, u).
namespace sph {

/// P = K rho^gamma, K > 0 constant entropy, gamma > 1.
struct Polytrope {
    double K, gamma;
    double pressure(double rho) const { return K * std::pow(rho, gamma); }
    double sound_speed(double rho) const { return std::sqrt(gamma * K * std::pow(rho, gamma - 1)); }
    double energy(double rho) const { return K / (gamma - 1) * std::pow(rho, gamma - 1); }
};

/// The same for gamma = 2, the gas of Monaghan & Price's toy stars and of shallow water: no powers needed.
struct Quadratic {
    double K;
    double pressure(double rho) const { return K * rho * rho; }
    double sound_speed(double rho) const { return std::sqrt(2 * K * rho); }
    double energy(double rho) const { return K * rho; }
};

/// P = c_s^2 rho; the energy counts from rho = 1.
struct Isothermal {
    double c_s;
    double pressure(double rho) const { return c_s * c_s * rho; }
    double sound_speed(double) const { return c_s; }
    double energy(double rho) const { return c_s * c_s * std::log(rho); }
};

/// A liquid: P = B [(rho/rho_0)^gamma - 1], B = rho_0 c_0^2/gamma, with c_0 ten times the flow's speed to
/// keep changes of density near 1 % (Cole 1948; Monaghan 2005, section 10, with gamma = 7). P < 0 for
/// rho < rho_0. The energy counts from rho = rho_0.
struct Cole {
    double rho_0, c_0, gamma = 7;
    double pressure(double rho) const {
        return rho_0 * c_0 * c_0 / gamma * (std::pow(rho / rho_0, gamma) - 1);
    }
    double sound_speed(double rho) const { return c_0 * std::pow(rho / rho_0, (gamma - 1) / 2); }
    double energy(double rho) const {
        const double r = rho / rho_0;
        return c_0 * c_0 / gamma * ((std::pow(r, gamma - 1) - 1) / (gamma - 1) + 1 / r - 1);
    }
};

/// P = (gamma - 1) rho u; gamma > 1.
struct IdealGas {
    double gamma;
    double pressure(double rho, double u) const { return (gamma - 1) * rho * u; }
    double energy(double rho, double p) const { return p / ((gamma - 1) * rho); }
    double sound_speed(double, double u) const { return std::sqrt(gamma * (gamma - 1) * u); }
};

/// Any equation of state with a thermal energy, as a value: scenes take one, and a gas need not be compiled
/// anew for each. Virtual once a column.
class ThermalState {
  public:
    template <class State>
    ThermalState(State state)  // NOLINT(google-explicit-constructor)
        : state_{std::make_shared<const Of<State>>(state)} {}

    /// The state itself, if it is of that type; otherwise none.
    template <class State>
    const State* as() const {
        const auto* of = dynamic_cast<const Of<State>*>(state_.get());
        return of ? &of->state : nullptr;
    }
    double energy(double rho, double p) const { return state_->energy(rho, p); }
    double sound_speed(double rho, double u) const { return state_->sound_speed(rho, u); }
    void set_pressure(const Column& rho, const Column& u, Column& p) const {
        state_->set_pressure(rho, u, p);
    }
    void set_sound_speed(const Column& rho, const Column& u, Column& c_s) const {
        state_->set_sound_speed(rho, u, c_s);
    }
    void set_energy(const Column& rho, const Column& p, Column& u) const { state_->set_energy(rho, p, u); }

  private:
    struct Any {
        virtual ~Any() = default;
        virtual double energy(double rho, double p) const = 0;
        virtual double sound_speed(double rho, double u) const = 0;
        virtual void set_pressure(const Column& rho, const Column& u, Column& p) const = 0;
        virtual void set_sound_speed(const Column& rho, const Column& u, Column& c_s) const = 0;
        virtual void set_energy(const Column& rho, const Column& p, Column& u) const = 0;
    };
    template <class State>
    struct Of final : Any {
        State state;
        explicit Of(State given) : state{given} {}
        double energy(double rho, double p) const override { return state.energy(rho, p); }
        double sound_speed(double rho, double u) const override { return state.sound_speed(rho, u); }
        void set_pressure(const Column& rho, const Column& u, Column& p) const override {
            for (std::size_t i = 0; i < rho.size(); ++i) p[i] = state.pressure(rho[i], u[i]);
        }
        void set_sound_speed(const Column& rho, const Column& u, Column& c_s) const override {
            for (std::size_t i = 0; i < rho.size(); ++i) c_s[i] = state.sound_speed(rho[i], u[i]);
        }
        void set_energy(const Column& rho, const Column& p, Column& u) const override {
            for (std::size_t i = 0; i < rho.size(); ++i) u[i] = state.energy(rho[i], p[i]);
        }
    };
    std::shared_ptr<const Any> state_;
};

}  // namespace sph
