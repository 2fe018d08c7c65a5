#pragma once
#include "common/core/effects.hpp"
#include "common/core/tile.hpp"

namespace sph {

/// The column From of an effect is here the column To, of the same shape.
template <class From, class To>
struct As {};

namespace renamed_detail {

template <class C, class... Names>
struct Target {
    using type = C;
};
template <class C, class To, class... Names>
struct Target<C, As<C, To>, Names...> {
    using type = To;
};
template <class C, class Other, class... Names>
struct Target<C, Other, Names...> : Target<C, Names...> {};

template <class L, class... Names>
struct Targets;
template <class... C, class... Names>
struct Targets<List<C...>, Names...> {
    using type = List<typename Target<C, Names...>::type...>;
};

}  // namespace renamed_detail

/// An effect written for other columns: the same sum, with what it reads and adds under names that say what
/// they hold. Renamed<GradHForce, As<Mass, Entropy>, As<Acceleration, MomentumRate>> is the pressure force by
/// entropy instead of by mass. The copies between the names are registers: nothing is left of them.
template <class E, class... Names>
struct Renamed {
    template <class L>
    using Of = typename renamed_detail::Targets<L, Names...>::type;
    template <template <class> class What>
    using Declared = effects_detail::Declared<What, E>;

    E effect{};
    using Reads = Of<Declared<effects_detail::Reads>>;
    using ReadsI = Of<Declared<effects_detail::ReadsI>>;
    using ReadsJ = Of<Declared<effects_detail::ReadsJ>>;
    using Adds = Of<Declared<effects_detail::Adds>>;

    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        constexpr int d = static_cast<int>(std::decay_t<decltype(pair.x_ij)>::size());
        const auto own_i = under_own_names<double, d>(
            i, Union<Declared<effects_detail::Reads>, Declared<effects_detail::ReadsI>>{});
        const auto own_j = under_own_names<Tile, d>(
            j, Union<Declared<effects_detail::Reads>, Declared<effects_detail::ReadsJ>>{});
        auto own_sum = under_own_names<Tile, d>(sum, Declared<effects_detail::Adds>{});
        effect.add(own_i, own_j, pair, own_sum);
        give_back<d>(own_sum, sum, Declared<effects_detail::Adds>{});
    }

  private:
    template <class C>
    using Target = typename renamed_detail::Target<C, Names...>::type;
    template <class T, int d, class... C>
    static Row<T, d, C...> under_own_names(const auto& row, List<C...>) {
        Row<T, d, C...> own;
        ((member<C, T, d>(own) = member<Target<C>, T, d>(row)), ...);
        return own;
    }
    template <int d, class... C>
    static void give_back(const auto& own, auto& sum, List<C...>) {
        ((member<Target<C>, Tile, d>(sum) = member<C, Tile, d>(own)), ...);
    }
};

}  // namespace sph
