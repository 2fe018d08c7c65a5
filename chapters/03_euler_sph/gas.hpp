#pragma once
#include <stdexcept>
#include <tuple>
#include <utility>

#include "chapters/03_euler_sph/equation_of_state.hpp"
#include "chapters/03_euler_sph/resolution.hpp"
#include "common/core/integrated.hpp"

/// Gases: particles, a resolution (where density and h come from), what the gas is made of, a boundary, and
/// external effects. They hold the columns and compute the effects that these list.
namespace sph {

/// Particles that resolve themselves, in a space that ends as Boundary says: what every gas of the book is
/// made of. More: the columns that it has besides; Base: Simulation or Integrated.
template <template <int> class Base, class Resolution, class Boundary, class More>
class Smoothed : public Base<Resolution::Kernel::dimension> {
    using Of = typename Resolution::Counts;

  public:
    using Kernel = typename Resolution::Kernel;
    static constexpr int d = Kernel::dimension;
    using P =
        ParticlesOf<d, Union<List<Position, Velocity, typename Of::Amount, typename Of::PerVolume, Pressure>,
                             typename Resolution::Columns, More>>;

    P particles;

    Groups& groups() override { return particles.groups; }
    Counters& counters() override { return neighbours_.counters(); }
    const Resolution& resolution() const { return resolution_; }

  protected:
    Smoothed(std::size_t n, Resolution resolution, Boundary boundary, int threads)
        : particles{n}, resolution_{std::move(resolution)}, neighbours_{std::move(boundary), threads} {
        this->offer(particles);
    }
    /// Density, h and neighbours at the present positions. What fails is told with the time t and whose it
    /// is.
    void find_density(double t) {
        try {
            resolution_.resolve(particles, neighbours_);
        } catch (const Unstable& failure) {
            throw failure.at(t);
        } catch (const std::invalid_argument&) {  // a position or h that is not a number
            require_physical_columns(typename P::Names{}, t);
            throw;
        }
    }
    /// Throws Unstable for the first value of the listed columns that has lost its meaning.
    template <class... C>
    void require_physical_columns(List<C...>, double t) const {
        const auto check = [&]<class One>(One) {
            for_each_component(
                [&](const Column& column) { require_physical(column, One::name, is_positive<One>, t); },
                member<One, Column, d>(particles));
        };
        (check(C{}), ...);
    }
    template <class... E>
    void sum(const Effects<E...>& effects) {
        sum_over_neighbours(particles, neighbours_, resolution_.smoothing(), effects);
    }
    /// A pass of effects without parameters; none if none are listed.
    template <class... E>
    void sum(List<E...>) {
        if constexpr (sizeof...(E) > 0) sum(Effects{E{}...});
    }
    app::Team& team() { return neighbours_.team(); }

    Resolution resolution_;

  private:
    Neighbours<d, Boundary> neighbours_;
};

/// Pressure is a function of density: the entropy of all particles is one constant.
template <class State>
struct Barotropic {
    using Columns = List<>;
    template <class Resolution>
    using Effects = List<>;

    State state;

    void evolve(Motion&, auto&) const {}
    void start(auto&) const {}
    template <class P>
    void set_pressure(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.p[i] = state.pressure(p.rho[i]);
    }
    template <class P>
    double energy(const P& p, std::size_t i) const {
        return state.energy(p.rho[i]);
    }
};

/// Each particle has a thermal energy, which pressure changes (3.14).
struct Thermal {
    using Columns = List<ThermalEnergy, Heating>;
    template <class Resolution>
    using Effects = List<typename Resolution::Heats>;

    ThermalState state;

    void evolve(Motion& motion, auto& particles) const { motion.evolve<ThermalEnergy, Heating>(particles); }
    template <class P>
    void start(P& p) const {
        state.set_energy(p.rho, p.p, p.u);
    }
    template <class P>
    void set_pressure(P& p) const {
        state.set_pressure(p.rho, p.u, p.p);
    }
    template <class P>
    double energy(const P& p, std::size_t i) const {
        return p.u[i];
    }
};

/// A gas without dissipation.
template <class Resolution, class Matter, class Boundary = Free, class... External>
class Gas
    : public Smoothed<Integrated, Resolution, Boundary, Union<List<Acceleration>, typename Matter::Columns>> {
    using Base =
        Smoothed<Integrated, Resolution, Boundary, Union<List<Acceleration>, typename Matter::Columns>>;

  public:
    static constexpr int d = Base::d;
    using Base::particles;

    Gas(std::size_t n, Resolution resolution, Matter matter, Boundary boundary, int threads,
        External... external)
        : Base{n, std::move(resolution), std::move(boundary), threads},
          matter_{matter},
          effects_{with_forces(typename Matter::template Effects<Resolution>{}, external...)},
          external_{external...} {
        Motion& motion = this->motion_ = Motion{this->team()};
        motion.evolve<Position, Velocity>(particles).template evolve<Velocity, Acceleration>(particles);
        this->resolution_.evolve(motion, particles);
        matter_.evolve(motion, particles);
        motion.watch(particles);
    }

    /// h from the density that a scene begins with, and thermal energy from its pressure.
    void start(double) override {
        this->resolution_.start(particles);
        matter_.start(particles);
    }
    void resolve(double t) override {
        this->find_density(t);
        matter_.set_pressure(particles);
    }
    void rates(double t) override {
        resolve(t);
        this->sum(effects_);
        if constexpr (requires { this->resolution_.rates(); }) this->sum(this->resolution_.rates());
    }
    /// sum m, sum m v, and sum m (v^2/2 + u + Phi), at a resolved state.
    Totals<d> totals() const override {
        Totals<d> sum;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const auto row = load<d>(particles, i, List<Position, Velocity>{});
            double by_mass = 0.5 * dot(row.v, row.v) + matter_.energy(particles, i);
            std::apply([&](const auto&... effect) { ((by_mass += potential(effect, row.x)), ...); },
                       external_);
            sum.mass += particles.m[i];
            sum.momentum += particles.m[i] * row.v;
            sum.energy += particles.m[i] * by_mass;
        }
        return sum;
    }

  private:
    template <class... Heats>
    static auto with_forces(List<Heats...>, const External&... external) {
        return Effects{typename Resolution::Force{}, Heats{}..., external...};
    }
    template <class Effect>
    static double potential(const Effect& effect, const Vector<d>& x) {
        if constexpr (requires { effect.potential(x); }) {
            return effect.potential(x);
        } else {
            return 0;
        }
    }

    Matter matter_;
    decltype(with_forces(typename Matter::template Effects<Resolution>{},
                         std::declval<External>()...)) effects_;
    std::tuple<External...> external_;
};

}  // namespace sph
