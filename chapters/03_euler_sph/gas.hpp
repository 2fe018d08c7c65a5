#pragma once
#include <stdexcept>
#include <utility>

#include "chapters/03_euler_sph/equation_of_state.hpp"
#include "chapters/03_euler_sph/resolution.hpp"
#include "common/core/integrators.hpp"

/// A gas without dissipation: particles, a resolution (where density and h come from), what the gas is made
/// of, a boundary, and external effects. It holds the columns and computes the effects that these list.
namespace sph {

/// Pressure is a function of density: the entropy of all particles is one constant.
template <class State>
struct Barotropic {
    using Columns = List<>;
    using Evolves = Equations<>;
    template <class Resolution>
    using Effects = List<>;

    State state;

    template <class P>
    void set_pressure(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.p[i] = state.pressure(p.rho[i]);
    }
    template <class P>
    double energy(const P& p, std::size_t i) const {
        return state.energy(p.rho[i]);
    }
    template <class P>
    double sound_speed(const P& p, std::size_t i) const {
        return state.sound_speed(p.rho[i]);
    }
};

/// Each particle has a thermal energy, which pressure changes (3.14).
struct Thermal {
    using Columns = List<ThermalEnergy, Heating>;
    using Evolves = Equations<Evolve<ThermalEnergy, Heating>>;
    template <class Resolution>
    using Effects = List<typename Resolution::Heats>;

    IdealGas state;

    template <class P>
    void set_pressure(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.p[i] = state.pressure(p.rho[i], p.u[i]);
    }
    template <class P>
    double energy(const P& p, std::size_t i) const {
        return p.u[i];
    }
    template <class P>
    double sound_speed(const P& p, std::size_t i) const {
        return state.sound_speed(p.u[i]);
    }
};

namespace gas_detail {
template <class... E>
struct Joined;
template <class... A>
struct Joined<Equations<A...>> {
    using type = Equations<A...>;
};
template <class... A, class... B, class... More>
struct Joined<Equations<A...>, Equations<B...>, More...> {
    using type = typename Joined<Equations<A..., B...>, More...>::type;
};
}  // namespace gas_detail

template <class Resolution, class Matter, class Boundary = Free, class... External>
class Gas {
  public:
    using Kernel = typename Resolution::Kernel;
    static constexpr int d = Kernel::dimension;
    using Motion =
        typename gas_detail::Joined<Equations<Evolve<Position, Velocity>, Evolve<Velocity, Acceleration>>,
                                    typename Resolution::Evolves, typename Matter::Evolves>::type;
    using P = ParticlesOf<d, Union<List<Position, Velocity, Acceleration, Mass, Density, Pressure>,
                                   typename Resolution::Columns, typename Matter::Columns>>;

    P particles;

    Gas(std::size_t n, Resolution resolution, Matter matter, Boundary boundary, int threads,
        External... external)
        : particles{n},
          resolution_{std::move(resolution)},
          matter_{matter},
          neighbours_{std::move(boundary), threads},
          effects_{with_forces(typename Matter::template Effects<Resolution>{}, external...)},
          external_{external...} {}

    /// The rates of all that evolves, at the particles' present state; for integrators.
    void rates(double t) {
        resolve(t);
        sum_over_neighbours(particles, neighbours_, resolution_.smoothing(), effects_);
        if constexpr (requires { resolution_.rates(); })
            sum_over_neighbours(particles, neighbours_, resolution_.smoothing(), resolution_.rates());
    }
    /// Density, smoothing length and pressure only.
    void resolve(double t) {
        try {
            resolution_.resolve(particles, neighbours_);
        } catch (const Unstable& failure) {
            throw Unstable{t, failure.particle, failure.quantity, failure.value};
        } catch (const std::invalid_argument&) {  // a position or h that is not a number: say when and whose
            require_physical(particles, t, typename P::Names{});
            throw;
        }
        matter_.set_pressure(particles);
    }

    /// sum m (v^2/2 + u + Phi), at a resolved state.
    double energy() const {
        double sum = 0;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const auto row = load<d>(particles, i, List<Position, Velocity>{});
            double by_mass = 0.5 * dot(row.v, row.v) + matter_.energy(particles, i);
            std::apply([&](const auto&... effect) { ((by_mass += potential(effect, row.x)), ...); },
                       external_);
            sum += particles.m[i] * by_mass;
        }
        return sum;
    }
    /// sum m v, along each axis.
    Vector<d> momentum() const {
        Vector<d> sum{};
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t i = 0; i < particles.size(); ++i) sum[a] += particles.m[i] * particles.v[a][i];
        }
        return sum;
    }
    /// The time step that sound allows: courant times the least h/(c_s), `h` each particle's.
    template <class H>
    double time_step(double courant, H&& h) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < particles.size(); ++i)
            least = std::min(least, h(i) / matter_.sound_speed(particles, i));
        return courant * least;
    }

    Counters& counters() { return neighbours_.counters(); }
    const Resolution& resolution() const { return resolution_; }
    const Matter& matter() const { return matter_; }

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

    Resolution resolution_;
    Matter matter_;
    Neighbours<d, Boundary> neighbours_;
    decltype(with_forces(typename Matter::template Effects<Resolution>{},
                         std::declval<External>()...)) effects_;
    std::tuple<External...> external_;
};

}  // namespace sph
