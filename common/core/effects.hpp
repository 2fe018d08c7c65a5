#pragma once
#include <tuple>

#include "common/core/particles.hpp"

/// Effects: what happens between particles, one small type each. A scene lists those it wants,
///     Effects{PressureForce{}, ArtificialViscosity{.alpha = 1}}
/// and one pass over the pairs is compiled for just these. What is not listed is never instantiated: no
/// branch, no column, no pass.
///
/// An effect says which columns it needs and has one or both of two functions:
///     struct PressureForce {
///         using Reads = List<Density, Pressure>;  // of both particles
///         using ReadsJ = List<Mass>;              // of the neighbour only (ReadsI: of the receiver only)
///         using Adds = List<Acceleration>;        // what it sums, stored in columns of these names
///         void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
///             sum.dv_dt -= (j.m * (i.p / square(i.rho) + j.p / square(j.rho)) * pair.F) * pair.x_ij;
///         }
///     };
/// add() is called with the numbers of the receiver i and the tiles of eight neighbours j. What a pair is
/// (x_ij, r, W, F, h) depends on the scene's smoothing.
///     void finish(const auto& i, const auto& sum, auto& out) const
/// is called once a particle with the finished sums; it writes `out`, which holds the columns of Adds, with
/// their sums, and those of Writes, which begin as zero.
///
/// An effect may build on the sums of others: `using Uses = List<ZerothMoment, Value>`. These are then part
/// of the pass, once, whoever uses them, and made without parameters; their sums reach finish(), and are
/// stored only if they are listed too.
namespace sph {

namespace effects_detail {

// Lists that an effect does not declare are empty.
template <class E>
auto reads() {
    if constexpr (requires { typename E::Reads; }) {
        return typename E::Reads{};
    } else {
        return List<>{};
    }
}
template <class E>
auto reads_i() {
    if constexpr (requires { typename E::ReadsI; }) {
        return typename E::ReadsI{};
    } else {
        return List<>{};
    }
}
template <class E>
auto reads_j() {
    if constexpr (requires { typename E::ReadsJ; }) {
        return typename E::ReadsJ{};
    } else {
        return List<>{};
    }
}
template <class E>
auto adds() {
    if constexpr (requires { typename E::Adds; }) {
        return typename E::Adds{};
    } else {
        return List<>{};
    }
}
template <class E>
auto writes() {
    if constexpr (requires { typename E::Writes; }) {
        return typename E::Writes{};
    } else {
        return List<>{};
    }
}
template <class E>
auto uses() {
    if constexpr (requires { typename E::Uses; }) {
        return typename E::Uses{};
    } else {
        return List<>{};
    }
}

/// An effect and all that it uses, directly or not.
template <class E>
struct Closure;
template <class... U>
struct ClosureOf;
template <class... U>
struct ClosureOf<List<U...>> {
    using type = Union<List<>, typename Closure<U>::type...>;
};
template <class E>
struct Closure {
    using type = Union<typename ClosureOf<decltype(uses<E>())>::type, List<E>>;
};

template <class L>
struct Needed;
template <class... E>
struct Needed<List<E...>> {
    using ReadI = Union<decltype(reads<E>())..., decltype(reads_i<E>())...>;
    using ReadJ = Union<decltype(reads<E>())..., decltype(reads_j<E>())...>;
    using Summed = Union<decltype(adds<E>())...>;
    static constexpr std::size_t pairwise =
        (std::size_t{0} + ... + (decltype(adds<E>())::size() > 0 ? 1 : 0));
};

}  // namespace effects_detail

/// Whether an effect sums over pairs.
template <class E>
inline constexpr bool is_pairwise = decltype(effects_detail::adds<E>())::size() > 0;

/// Effects that act together in one pass. Their Adds of one name are one sum.
template <class... E>
struct Effects {
    std::tuple<E...> list;

    constexpr explicit Effects(E... effects) : list{effects...} {}

    using Used = Difference<typename effects_detail::ClosureOf<List<E...>>::type, List<E...>>;
    /// Columns read of the receiver and of the neighbour; summed; stored.
    using Needed = effects_detail::Needed<Union<List<E...>, Used>>;
    using ReadI = typename Needed::ReadI;
    using ReadJ = typename Needed::ReadJ;
    using Summed = typename Needed::Summed;
    using Stored = Union<decltype(effects_detail::adds<E>())..., decltype(effects_detail::writes<E>())...>;
    /// How many of them sum over pairs.
    static constexpr std::size_t pairwise() { return Needed::pairwise; }
};

}  // namespace sph
