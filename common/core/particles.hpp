#pragma once
#include <cstddef>
#include <type_traits>

#include "common/core/columns.hpp"
#include "common/core/groups.hpp"
#include "common/core/list.hpp"

namespace sph {

/// Some columns for T: one particle's values (T = double), eight neighbours' (T = Tile). Members are named by
/// the columns: row.m, row.rho, row.v[0].
template <class T, int d, class... C>
struct Row : C::template In<T, d>... {
    static constexpr int dimension = d;
    using Names = List<C...>;
};
namespace particles_detail {
template <class T, int d, class L>
struct RowOf;
template <class T, int d, class... C>
struct RowOf<T, d, List<C...>> {
    using type = Row<T, d, C...>;
};
}  // namespace particles_detail
template <class T, int d, class L>
using RowOf = typename particles_detail::RowOf<T, d, L>::type;

/// The only member of a column, whatever its name: a T or a Vec of them.
template <class C, class T, int d, class Holder>
constexpr auto& member(Holder& holder) {
    using In = std::conditional_t<std::is_const_v<Holder>, const typename C::template In<T, d>,
                                  typename C::template In<T, d>>;
    auto& [value] = static_cast<In&>(holder);
    return value;
}

/// Calls visit(a, b, ...) on corresponding components of values of one shape: numbers, vectors, tensors.
template <class Visit, class First, class... More>
constexpr void for_each_component(Visit&& visit, First& first, More&... more) {
    if constexpr (IsVec<std::remove_const_t<First>>::value) {
        for (std::size_t a = 0; a < first.size(); ++a) for_each_component(visit, first[a], more[a]...);
    } else {
        visit(first, more...);
    }
}
/// Numbers in a row of the listed columns.
template <int d, class... C>
constexpr std::size_t count_components(List<C...>) {
    return (std::size_t{0} + ... + (sizeof(typename C::template In<double, d>) / sizeof(double)));
}

/// Particles in `dimension` dimensions as columns, only those that are listed: particles.rho[i],
/// particles.v[axis][i]. They keep the order in which the scene made them.
template <int dimension, class... C>
class Particles : public C::template In<Column, dimension>... {
  public:
    static constexpr int d = dimension;
    static_assert(d >= 1 && d <= 3);
    using Names = List<C...>;
    using Held = Column;

    Groups groups;  ///< which of them forces move

    Particles() = default;
    /// `n` particles with zeros in every column.
    explicit Particles(std::size_t n) { resize(n); }

    std::size_t size() const noexcept { return size_; }
    /// New particles have zeros in every column.
    void resize(std::size_t n) {
        size_ = n;
        for_each_column([n](auto, auto& column) { column.resize(n); });
    }
    /// Calls visit(C, column) for each column of numbers; a vector has one per component.
    template <class Visit>
    void for_each_column(Visit&& visit) {
        (for_each_component([&](auto& column) { visit(C{}, column); }, member<C, Column, d>(*this)), ...);
    }
    template <class Visit>
    void for_each_column(Visit&& visit) const {
        (for_each_component([&](const auto& column) { visit(C{}, column); }, member<C, Column, d>(*this)),
         ...);
    }

  private:
    std::size_t size_ = 0;
};

namespace particles_detail {
template <int d, class L>
struct ParticlesOf;
template <int d, class... C>
struct ParticlesOf<d, List<C...>> {
    using type = Particles<d, C...>;
};
}  // namespace particles_detail
/// Particles with the columns of a list.
template <int d, class L>
using ParticlesOf = typename particles_detail::ParticlesOf<d, L>::type;

/// Makes the columns of `to` those of particles that have them too.
template <class From, int d, class... C>
void copy_columns(const From& from, Particles<d, C...>& to) {
    to.resize(from.size());
    const auto copy = [&]<class One>(One) {
        if constexpr (contains<typename From::Names, One>)
            member<One, Column, d>(to) = member<One, Column, d>(from);
    };
    (copy(C{}), ...);
}

template <class P, class C>
concept Has = contains<typename P::Names, C>;

/// Holds when particles have a column; where they do not, the compiler names it here: "Needs<..., Missing>".
template <class P, class C>
struct Needs {
    static_assert(Has<P, C>, "the particles lack a column that an effect names");
    static constexpr bool met = true;
};
template <class P, class... C>
constexpr bool has_all(List<C...>) {
    return (Needs<P, C>::met && ...);
}

/// Where the listed columns begin, and nothing else of the particles: what a loop over them is compiled for.
/// Begin is double* or const double*.
template <class Begin, int dimension, class... C>
struct View : C::template In<Begin, dimension>... {
    static constexpr int d = dimension;
    using Names = List<C...>;
    using Held = Begin;
};
namespace particles_detail {
template <class Begin, int d, class L>
struct ViewOf;
template <class Begin, int d, class... C>
struct ViewOf<Begin, d, List<C...>> {
    using type = View<Begin, d, C...>;
};
}  // namespace particles_detail
template <class Begin, int d, class L>
using ViewOf = typename particles_detail::ViewOf<Begin, d, L>::type;
template <class Begin, class P, class... C>
View<Begin, std::remove_const_t<P>::d, C...> view_of([[maybe_unused]] P& particles, List<C...>) {
    constexpr int d = std::remove_const_t<P>::d;
    View<Begin, d, C...> view;
    (for_each_component([](Begin& begin, auto& column) { begin = column.data(); }, member<C, Begin, d>(view),
                        member<C, Column, d>(particles)),
     ...);
    return view;
}

/// The values of particle i in the listed columns, of particles or of a view.
template <int d, class P, class... C>
Row<double, d, C...> load(const P& particles, [[maybe_unused]] std::size_t i, List<C...>) {
    Row<double, d, C...> row;
    (for_each_component([i](double& value, const auto& column) { value = column[i]; },
                        member<C, double, d>(row), member<C, typename P::Held, d>(particles)),
     ...);
    return row;
}
template <int d, class P, class... C>
void store(P& particles, [[maybe_unused]] std::size_t i, const Row<double, d, C...>& row) {
    (for_each_component([i](const double& value, auto& column) { column[i] = value; },
                        member<C, double, d>(row), member<C, typename P::Held, d>(particles)),
     ...);
}

}  // namespace sph
