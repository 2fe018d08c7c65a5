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

template <class E>
using Reads = typename E::Reads;
template <class E>
using ReadsI = typename E::ReadsI;
template <class E>
using ReadsJ = typename E::ReadsJ;
template <class E>
using Adds = typename E::Adds;
template <class E>
using Writes = typename E::Writes;
template <class E>
using Uses = typename E::Uses;

/// What an effect declares under one of these names; nothing if it does not.
template <template <class> class Name, class E>
struct DeclaredBy {
    using type = List<>;
};
template <template <class> class Name, class E>
requires requires {
    typename Name<E>;
}
struct DeclaredBy<Name, E> {
    using type = Name<E>;
};
template <template <class> class Name, class E>
using Declared = typename DeclaredBy<Name, E>::type;

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
    using type = Union<typename ClosureOf<Declared<Uses, E>>::type, List<E>>;
};

template <class L>
struct Needed;
template <class... E>
struct Needed<List<E...>> {
    using ReadI = Union<Declared<Reads, E>..., Declared<ReadsI, E>...>;
    using ReadJ = Union<Declared<Reads, E>..., Declared<ReadsJ, E>...>;
    using Summed = Union<Declared<Adds, E>...>;
    static constexpr std::size_t pairwise = (std::size_t{0} + ... + (Declared<Adds, E>::size() > 0 ? 1 : 0));
};

}  // namespace effects_detail

/// Whether an effect sums over pairs.
template <class E>
inline constexpr bool is_pairwise = effects_detail::Declared<effects_detail::Adds, E>::size() > 0;

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
    using Stored = Union<effects_detail::Declared<effects_detail::Adds, E>...,
                         effects_detail::Declared<effects_detail::Writes, E>...>;
    /// How many of them sum over pairs.
    static constexpr std::size_t pairwise() { return Needed::pairwise; }
};

}  // namespace sph
