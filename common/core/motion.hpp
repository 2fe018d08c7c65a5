#pragma once
#include <string_view>
#include <vector>

#include "common/app/team.hpp"
#include "common/core/particles.hpp"

namespace sph {

template <class C>
inline constexpr bool is_positive = requires {
    C::positive;
};
template <class C>
inline constexpr bool is_held = requires {
    C::held;
};

/// What changes in time, and by which rate: all that an integrator needs to know of particles.
///     Motion motion{team};
///     motion.evolve<Position, Velocity>(particles).evolve<Velocity, Acceleration>(particles);
/// An equation whose rate is itself a value (dx/dt = v) is a drift, any other one a kick. Held particles keep
/// what says `held`. The particles and the team must outlive it, and stay where they are.
class Motion {
  public:
    Motion() = default;  // on this thread alone
    explicit Motion(app::Team& team) : team_{&team} {}

    /// d Value/dt = Rate, both columns of one shape.
    template <class Value, class Rate, class P>
    Motion& evolve(P& particles) {
        static_assert(has_all<P>(List<Value, Rate>{}));
        for_each_component(
            [&](Column& value, const Column& rate) {
                add({Value::name, &value, &rate, is_held<Value> ? &particles.groups : nullptr,
                     is_positive<Value>});
            },
            member<Value, Column, P::d>(particles), member<Rate, Column, P::d>(particles));
        return *this;
    }
    /// Makes require_physical() look at every column that says `positive`, too.
    template <class P>
    Motion& watch(const P& particles) {
        particles.for_each_column([&]<class C>(C, const Column& column) {
            if constexpr (is_positive<C>) watched_.push_back({C::name, &column});
        });
        return *this;
    }

    /// value += dt rate, for all drifts or all kicks.
    void drift(double dt) const { advance(true, dt); }
    void kick(double dt) const { advance(false, dt); }
    /// Throws Unstable if what evolves, or a watched column, has lost its meaning.
    void require_physical(double t) const;

    /// A copy of what evolves. Keeps its memory.
    class Saved {
      public:
        void save(const Motion& motion);
        void restore(const Motion& motion) const;
        /// value = saved + dt rate; drifts before kicks, so that x moves with the velocity that belongs to
        /// it.
        void advance(const Motion& motion, double dt) const;
        /// saved += dt rate
        void add(const Motion& motion, double dt);

      private:
        std::vector<Column> columns_;
    };

  private:
    struct Evolving {
        std::string_view name;
        Column* value;
        const Column* rate;
        const Groups* groups;  // whose held particles keep the value
        bool positive;
        bool drift = false;
    };
    struct Watched {
        std::string_view name;
        const Column* column;
    };
    void add(const Evolving& equation);
    void advance(bool drifts, double dt) const;
    /// Calls visit(begin, end) on ranges of the particles that change, on all threads.
    template <class Visit>
    void for_each_range(const Evolving& equation, Visit&& visit) const;

    app::Team* team_ = nullptr;
    std::vector<Evolving> equations_;  // drifts first
    std::vector<Watched> watched_;
};

}  // namespace sph
