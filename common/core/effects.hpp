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
/// their sums, and those of Writes, which begin as zero. Sums that serve only finish() are listed as Sums:
/// they are not stored.
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
auto sums() {
    if constexpr (requires { typename E::Sums; }) {
        return typename E::Sums{};
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

}  // namespace effects_detail

/// Effects that act together in one pass. Their Adds of one name are one sum.
template <class... E>
struct Effects {
    std::tuple<E...> list;

    constexpr explicit Effects(E... effects) : list{effects...} {}

    /// Columns read of the receiver and of the neighbour; summed; stored.
    using ReadI = Union<decltype(effects_detail::reads<E>())..., decltype(effects_detail::reads_i<E>())...>;
    using ReadJ = Union<decltype(effects_detail::reads<E>())..., decltype(effects_detail::reads_j<E>())...>;
    using Added = Union<decltype(effects_detail::adds<E>())...>;
    using Summed = Union<Added, decltype(effects_detail::sums<E>())...>;
    using Stored = Union<Added, decltype(effects_detail::writes<E>())...>;

    /// How many of them sum over pairs.
    static constexpr std::size_t pairwise() {
        return (
            std::size_t{0} + ... +
            (Union<decltype(effects_detail::adds<E>()), decltype(effects_detail::sums<E>())>{}.size() > 0));
    }
};

}  // namespace sph
