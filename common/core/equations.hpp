#pragma once
#include <cstddef>
#include <vector>

#include "common/core/particles.hpp"
#include "common/core/unstable.hpp"

/// What changes in time, and by which rate: the types that integrators work on.
namespace sph {

/// d Value / dt = Rate, both columns of one shape.
template <class Value, class Rate>
struct Evolve {
    using value = Value;
    using rate = Rate;
};

/// The equations of a scene, for instance
///     using Motion = Equations<Evolve<Position, Velocity>, Evolve<Velocity, Acceleration>>;
/// An equation whose rate is itself a value (dx/dt = v) is a drift, any other one a kick.
template <class... E>
struct Equations {
    using Values = List<typename E::value...>;
    using Columns = Union<Values, List<typename E::rate...>>;

    template <class Equation>
    static constexpr bool is_drift = contains<Values, typename Equation::rate>;

    /// Calls visit(value, rate, count) for each component of the equations that `wanted` picks, drifts before
    /// kicks: so x is moved by the velocity that belongs to it. `count` particles change: fixed ones keep
    /// position and velocity, but their other quantities evolve.
    template <class P, class Visit>
    static void for_each_drift(P& particles, Visit&& visit) {
        (apply<E, true>(particles, visit), ...);
    }
    template <class P, class Visit>
    static void for_each_kick(P& particles, Visit&& visit) {
        (apply<E, false>(particles, visit), ...);
    }
    template <class P, class Visit>
    static void for_each(P& particles, Visit&& visit) {
        for_each_drift(particles, visit);
        for_each_kick(particles, visit);
    }

    /// value += dt rate, for all drifts or all kicks.
    template <class P>
    static void drift(P& particles, double dt) {
        for_each_drift(particles, [dt](Column& value, const Column& rate, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) value[i] += dt * rate[i];
        });
    }
    template <class P>
    static void kick(P& particles, double dt) {
        for_each_kick(particles, [dt](Column& value, const Column& rate, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) value[i] += dt * rate[i];
        });
    }

    /// Throws Unstable if what the equations evolve, or any positive column of the particles, has lost its
    /// meaning.
    template <class P>
    static void require_physical(const P& particles, double t) {
        sph::require_physical(particles, t, Values{});
        require_positive(particles, t, typename P::Names{});
    }

  private:
    template <class Equation, bool drift, class P, class Visit>
    static void apply(P& particles, Visit&& visit) {
        using ValueColumn = typename Equation::value;
        using RateColumn = typename Equation::rate;
        static_assert(has_all<P>(List<ValueColumn, RateColumn>{}));
        if constexpr (is_drift<Equation> == drift) {
            constexpr bool moves =
                std::is_same_v<ValueColumn, Position> || std::is_same_v<ValueColumn, Velocity>;
            const std::size_t count = moves ? particles.moving() : particles.size();
            for_each_component([&](Column& value, const Column& rate) { visit(value, rate, count); },
                               member<ValueColumn, Column, P::d>(particles),
                               member<RateColumn, Column, P::d>(particles));
        }
    }
    template <class P, class... C>
    static void require_positive(const P& particles, double t, List<C...>) {
        using Positive = Union < List<>, std::conditional_t < requires {
            C::positive;
        }
        , List<C>, List < >> ... > ;
        sph::require_physical(particles, t, Difference<Positive, Values>{});
    }
};

/// A copy of what the equations evolve. Keeps its memory.
template <class Motion>
class Saved {
  public:
    template <class P>
    void save(P& particles) {
        std::size_t k = 0;
        Motion::for_each(particles, [&](Column& value, const Column&, std::size_t) {
            if (k == columns_.size()) columns_.emplace_back();
            columns_[k++].assign(value.begin(), value.end());
        });
    }
    /// value = saved + dt rate
    template <class P>
    void advance(P& particles, double dt) const {
        std::size_t k = 0;
        Motion::for_each(particles, [&](Column& value, const Column& rate, std::size_t count) {
            const Column& saved = columns_[k++];
            for (std::size_t i = 0; i < count; ++i) value[i] = saved[i] + dt * rate[i];
        });
    }
    /// saved += dt rate
    template <class P>
    void add(P& particles, double dt) {
        std::size_t k = 0;
        Motion::for_each(particles, [&](Column&, const Column& rate, std::size_t count) {
            Column& saved = columns_[k++];
            for (std::size_t i = 0; i < count; ++i) saved[i] += dt * rate[i];
        });
    }

  private:
    std::vector<Column> columns_;
};

}  // namespace sph
