#pragma once
#include <cstddef>
#include <type_traits>

/// Lists of types, joined and asked at compile time: how an effect says which columns it reads and adds.
namespace sph {

template <class... C>
struct List {
    static constexpr std::size_t size() { return sizeof...(C); }
};

template <class L, class C>
inline constexpr bool contains = false;
template <class... L, class C>
inline constexpr bool contains<List<L...>, C> = (std::is_same_v<L, C> || ...);

namespace list_detail {

template <class L, class... C>
struct Append;
template <class... L>
struct Append<List<L...>> {
    using type = List<L...>;
};
template <class... L, class C, class... More>
struct Append<List<L...>, C, More...> {
    using with_c = std::conditional_t<contains<List<L...>, C>, List<L...>, List<L..., C>>;
    using type = typename Append<with_c, More...>::type;
};

template <class... L>
struct Union {
    using type = List<>;
};
template <class... C>
struct Union<List<C...>> {
    using type = typename Append<List<>, C...>::type;
};
template <class... A, class... B, class... More>
struct Union<List<A...>, List<B...>, More...> {
    using type = typename Union<typename Append<List<A...>, B...>::type, More...>::type;
};

template <class L, class Without>
struct Difference;
template <class... C, class Without>
struct Difference<List<C...>, Without> {
    using type = typename Union<List<>, std::conditional_t<contains<Without, C>, List<>, List<C>>...>::type;
};

}  // namespace list_detail

/// The types of all lists, each once, in the order of their first appearance.
template <class... Lists>
using Union = typename list_detail::Union<Lists...>::type;
/// The types of `L` that are not in `Without`.
template <class L, class Without>
using Difference = typename list_detail::Difference<L, Without>::type;

}  // namespace sph
