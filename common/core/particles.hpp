#pragma once
#include <concepts>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "common/core/columns.hpp"
#include "common/core/list.hpp"
#include "common/core/tile.hpp"

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

    Particles() = default;
    /// `n` particles with zeros in every column.
    explicit Particles(std::size_t n) { resize(n); }

    std::size_t size() const noexcept { return size_; }
    /// The particles from this one on stay where they are (layers that stand for a wall): integrators do not
    /// move them. All others move by default.
    std::size_t moving() const noexcept { return std::min(moving_, size_); }
    void fix_from(std::size_t first) noexcept { moving_ = first; }

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
    std::size_t moving_ = std::numeric_limits<std::size_t>::max();
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

/// The values of particle i in the listed columns.
template <int d, class P, class... C>
Row<double, d, C...> load(const P& particles, [[maybe_unused]] std::size_t i, List<C...>) {
    Row<double, d, C...> row;
    (for_each_component([i](double& value, const Column& column) { value = column[i]; },
                        member<C, double, d>(row), member<C, Column, d>(particles)),
     ...);
    return row;
}
template <int d, class P, class... C>
void store(P& particles, [[maybe_unused]] std::size_t i, const Row<double, d, C...>& row) {
    (for_each_component([i](const double& value, Column& column) { column[i] = value; },
                        member<C, double, d>(row), member<C, Column, d>(particles)),
     ...);
}

}  // namespace sph
