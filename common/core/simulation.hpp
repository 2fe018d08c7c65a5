#pragma once
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <typeindex>
#include <typeinfo>
#include <vector>

#include "common/core/march.hpp"
#include "common/core/neighbour_list.hpp"
#include "common/core/particles.hpp"

namespace sph {

/// What stays the same, or should: with what held particles would have gained, had they been free.
template <int d>
struct Totals {
    double mass = 0;
    Vector<d> momentum{};
    double energy = 0;
};

/// What scenes, time loops and reports need of any particle method, without its types: so each scene is
/// written once, and each method is compiled once. Virtual once a step, never in a loop over particles.
template <int dimension>
class Simulation : public Stepper {
  public:
    static constexpr int d = dimension;

    /// Takes what a scene has written into the columns Position, Velocity, Mass, Density (of matter at rest)
    /// and, where there is one, Pressure, and makes of it what the method evolves, at time t. Throws
    /// Unstable, and std::invalid_argument for a state that the method has not.
    virtual void start(double t) = 0;
    /// Density, pressure and what else follows from what evolves, at the present state. Throws Unstable.
    virtual void resolve(double t) = 0;
    /// At a resolved state.
    virtual Totals<d> totals() const = 0;

    /// A column of all particles, get<Density>()[i], get<Velocity>()[axis][i]. Throws std::out_of_range
    /// naming one that the method does not have.
    template <class C>
    auto& get() {
        return *static_cast<decltype(&member<C, Column, d>(std::declval<Holder<C>&>()))>(
            find(typeid(C), C::name));
    }
    template <class C>
    const auto& get() const {
        return const_cast<Simulation*>(this)->template get<C>();
    }
    template <class C>
    bool has() const {
        return std::any_of(columns_.begin(), columns_.end(),
                           [](const Offered& one) { return one.type == typeid(C); });
    }
    std::size_t size() const { return get<Position>()[0].size(); }
    /// Particle i as a scene begins with it: density and pressure of matter at rest. To be called before
    /// start().
    void place(std::size_t i, const Vector<d>& x, const Vector<d>& v, double m, double rho, double p) {
        for (std::size_t a = 0; a < d; ++a) get<Position>()[a][i] = x[a], get<Velocity>()[a][i] = v[a];
        get<Mass>()[i] = m, get<Density>()[i] = rho, get<Pressure>()[i] = p;
    }

    virtual Groups& groups() = 0;
    virtual Counters& counters() = 0;

  protected:
    /// To be called once by who owns the particles.
    template <class... C>
    void offer(Particles<d, C...>& particles) {
        (columns_.push_back({typeid(C), &member<C, Column, d>(particles)}), ...);
    }

  private:
    template <class C>
    using Holder = typename C::template In<Column, d>;
    struct Offered {
        std::type_index type;
        void* column;
    };
    void* find(std::type_index type, std::string_view name) const {
        for (const Offered& one : columns_) {
            if (one.type == type) return one.column;
        }
        throw std::out_of_range{"this method has no column of " + std::string{name}};
    }

    std::vector<Offered> columns_;
};

/// march() for a simulation: its steps are counted.
template <int d, class... AfterStep>
Marched march(Simulation<d>& simulation, double& t, const StepControl& how, AfterStep&&... after_step) {
    Stepper& stepper = simulation;
    const Marched done = march(stepper, t, how, std::forward<AfterStep>(after_step)...);
    simulation.counters().steps += done.steps;
    return done;
}

/// How far the totals of a simulation have been from where they began.
template <int d>
class Drifts {
  public:
    explicit Drifts(const Simulation<d>& simulation)
        : simulation_{&simulation}, first_{simulation.totals()} {}
    const Totals<d>& first() const { return first_; }
    /// The largest change that look() has seen; of momentum, of a component.
    double energy() const { return energy_; }
    double momentum() const { return momentum_; }
    /// At a resolved state.
    void look() {
        const Totals<d> now = simulation_->totals();
        energy_ = std::max(energy_, std::abs(now.energy - first_.energy));
        for (std::size_t a = 0; a < d; ++a)
            momentum_ = std::max(momentum_, std::abs(now.momentum[a] - first_.momentum[a]));
    }

  private:
    const Simulation<d>* simulation_;
    Totals<d> first_;
    double energy_ = 0, momentum_ = 0;
};

}  // namespace sph
