#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <utility>

#include "common/app/program.hpp"
#include "common/core/effects.hpp"
#include "common/core/neighbours.hpp"

/// The tile loop: one pass over all pairs for the listed effects, and nothing else.
namespace sph {

namespace pass_detail {

/// Columns that pairs need of a neighbour: what effects and smoothing read, without the position, which comes
/// from the search (a ghost has its own).
template <class Smoothing, class E>
using Packed = Difference<Union<typename Effects<Smoothing>::ReadJ, typename E::ReadJ>, List<Position>>;
template <class Smoothing, class E>
using OfReceiver = Union<typename Effects<Smoothing>::ReadI, typename E::ReadI>;

/// Component a of a vector is multiplied by sign[a], component (a, b) of a tensor by sign[a] sign[b].
template <int d>
void reflect(double& value, const Vector<d>&, double factor) {
    value *= factor;
}
template <class T, int d>
void reflect(Vec<T, d>& value, const Vector<d>& sign, double factor) {
    for (std::size_t a = 0; a < value.size(); ++a) reflect(value[a], sign, factor * sign[a]);
}

/// What ghosts carry is their owners' values, unless a boundary sets it.
struct OwnersValues {};

/// Copies what pairs need of every source, particle or ghost, into its row.
template <class Values, int d, class... C>
void pack(const View<const double*, d, C...>& particles, NeighbourList<d>& neighbours, const Values& ghosts) {
    constexpr List<C...> columns;
    constexpr std::size_t width = static_cast<std::size_t>(d) + count_components<d>(columns);
    RowBuffer& rows = neighbours.rows();
    rows.resize(neighbours.sources(), width);
    const auto pack_rows = [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            auto values = load<d>(particles, neighbours.owner(k), columns);
            if (const Ghost<d>* ghost = neighbours.ghost(k)) {
                (reflect(member<C, double, d>(values), ghost->sign, 1.0), ...);
                if constexpr (!std::is_same_v<Values, OwnersValues>) ghosts.values(values, *ghost);
            }
            double* out = rows.row(k);
            const Vector<d> x = neighbours.source_position(k);
            for (std::size_t a = 0; a < d; ++a) *out++ = x[a];
            (for_each_component([&](double value) { *out++ = value; }, member<C, double, d>(values)), ...);
        }
    };
    constexpr std::size_t grain = 1 << 13;  // rows for which waking a thread pays
    neighbours.team().parallel_for(neighbours.sources(), pack_rows, grain);
}
template <int d, class B, class V>
void pack(const V& particles, Neighbours<d, B>& neighbours) {
    if constexpr (requires { &B::template values<Row<double, d>, d>; }) {
        pack(particles, neighbours, neighbours.boundary());
    } else {
        pack(particles, neighbours, OwnersValues{});
    }
}

/// Eight neighbours of i: their offsets and columns.
template <int d, class... C>
struct Neighbour : Row<Tile, d, C...> {
    Vec<Tile, d> x_ij;

    Neighbour(const RowBuffer& rows, const std::uint32_t* index, const Vector<d>& x_i, List<C...> columns) {
        constexpr std::size_t width = static_cast<std::size_t>(d) + count_components<d>(decltype(columns){});
        const auto tiles = tiles_of<width>(rows, index);
        std::size_t next = 0;
        for (std::size_t a = 0; a < d; ++a) x_ij[a] = x_i[a] - tiles[next++];
        (for_each_component([&](Tile& tile) { tile = tiles[next++]; }, member<C, Tile, d>(*this)), ...);
    }
};

template <class Sums>
struct SumTiles;
template <class... C>
struct SumTiles<List<C...>> {
    /// Where a column sums; one may say `maximum`, and then holds the largest term instead.
    template <class Column>
    static constexpr bool maximum = requires {
        Column::maximum;
    };

    template <int d>
    static void clear(Row<Tile, d, C...>& sum) {
        (for_each_component(
             [](Tile& tile) {
                 if constexpr (maximum<C>) {
                     tile = -std::numeric_limits<double>::infinity();
                 } else {
                     tile = 0.0;
                 }
             },
             member<C, Tile, d>(sum)),
         ...);
    }
    template <int d>
    static Row<double, d, C...> reduce(const Row<Tile, d, C...>& sum) {
        Row<double, d, C...> total;
        (for_each_component(
             [](double& value, const Tile& tile) { value = maximum<C> ? tile.maxCoeff() : tile.sum(); },
             member<C, double, d>(total), member<C, Tile, d>(sum)),
         ...);
        return total;
    }
};

/// The columns that both rows have.
template <int d, class To, class... C>
void copy_common(const Row<double, d, C...>& from, To& to) {
    const auto copy = [&]<class Column>(Column) {
        if constexpr (contains<typename To::Names, Column>)
            member<Column, double, d>(to) = member<Column, double, d>(from);
    };
    (copy(C{}), ...);
}

template <class E>
void add_one(const E& effect, const auto& i, const auto& j, const auto& pair, auto& sum) {
    constexpr bool has_add = requires {
        effect.add(i, j, pair, sum);
    };
    static_assert(has_add == is_pairwise<E>,
                  "an effect with add() names what it sums in Adds, and only such a one");
    if constexpr (has_add) effect.add(i, j, pair, sum);
}
template <class... U>
void add_used(List<U...>, [[maybe_unused]] const auto& i, [[maybe_unused]] const auto& j,
              [[maybe_unused]] const auto& pair, [[maybe_unused]] auto& sum) {
    (add_one(U{}, i, j, pair, sum), ...);
}
template <class... E>
void add_all(const Effects<E...>& effects, const auto& i, const auto& j, const auto& pair, auto& sum) {
    std::apply([&](const auto&... effect) { (add_one(effect, i, j, pair, sum), ...); }, effects.list);
    add_used(typename Effects<E...>::Used{}, i, j, pair, sum);
}
template <class... E>
void finish_all(const Effects<E...>& effects, const auto& i, const auto& sum, auto& out) {
    const auto finish = [&](const auto& effect) {
        if constexpr (requires { effect.finish(i, sum, out); }) effect.finish(i, sum, out);
    };
    std::apply([&](const auto&... effect) { (finish(effect), ...); }, effects.list);
}

#ifdef SPH_SANITIZED
inline constexpr bool all_inlined = false;  // compilers take minutes for it, and debuggers want calls
#else
inline constexpr bool all_inlined = true;
#endif

/// What a pass is compiled for: the smoothing, the effects, and where the columns that they name begin.
template <int d, class Smoothing, class E>
struct Sum {
    using Read = OfReceiver<Smoothing, E>;
    using Write = typename E::Stored;
    ViewOf<const double*, d, Read> read;
    ViewOf<double*, d, Write> write;
    Smoothing smoothing;
    E effects;
};

/// The sums of receivers begin..end over the tiles of their neighbours: where the time of a run goes. Effects
/// and smoothing are copies, so that the compiler need not fear that a sum overwrites them. Returns how many
/// pairs it visited.
template <int d, class Smoothing, class E>
std::size_t sum_receivers(Sum<d, Smoothing, E> pass, NeighbourList<d>& neighbours, std::size_t begin,
                          std::size_t end, std::size_t part) {
    using Sums = SumTiles<typename E::Summed>;
    const RowBuffer& rows = neighbours.rows();
    const double beyond = 1e3 * neighbours.largest_reach();
    std::size_t visited = 0;
    for (std::size_t r = begin; r < end; ++r) {
        const auto receiver = neighbours.receivers()[r];
        const auto [index, count] = neighbours.of(r, neighbours.scratch(part));
        const auto i = load<d>(pass.read, receiver.index, typename decltype(pass)::Read{});
        RowOf<Tile, d, typename E::Summed> sums;
        Sums::clear(sums);
        for (std::size_t k = 0; k < count; k += tile_width) {
            Neighbour j{rows, index + k, receiver.x, Packed<Smoothing, E>{}};
            // Lanes behind the last neighbour repeat it, moved to where W and F are zero.
            j.x_ij[0] += beyond * unused_lanes(std::min(count - k, tile_width));
            add_all(pass.effects, i, j, pass.smoothing.pair(i, j, j.x_ij), sums);
        }
        const auto sum = Sums::reduce(sums);
        RowOf<double, d, typename E::Stored> out{};
        copy_common(sum, out);
        finish_all(pass.effects, i, sum, out);
        store<d>(pass.write, receiver.index, out);
        visited += count;
    }
    return visited;
}
/// The same with everything inlined into it: tiles live in registers, and a call would send them through
/// memory.
template <int d, class Smoothing, class E>
[[gnu::flatten, gnu::noinline]] std::size_t sum_receivers_inlined(const Sum<d, Smoothing, E>& pass,
                                                                  NeighbourList<d>& neighbours,
                                                                  std::size_t begin, std::size_t end,
                                                                  std::size_t part) {
    return sum_receivers(pass, neighbours, begin, end, part);
}

}  // namespace pass_detail

/// One pass: for each receiver whose neighbours were found, sums the listed effects over them and stores the
/// results in the receivers' columns. `sources` are the particles whose positions were searched; `receivers`
/// the same object, or the points of find_around(). `smoothing` makes the pair: it has pair(i, j, x_ij)
/// and says what it reads as effects do. A column that is named and missing is a compile error that names it.
/// Throws std::logic_error unless find() was called for as many particles.
/// Bitwise the same for any number of threads, since each receiver sums its own neighbours in the order of
/// the cells. Cost: 3-4 ns a pair for a full set of forces in 3D; rows take (d + columns read) numbers a
/// source.
template <class Receivers, class Sources, class N, class Smoothing, class... E>
void sum_over_neighbours(Receivers& receivers, const Sources& sources, N& neighbours,
                         const Smoothing& smoothing, const Effects<E...>& effects) {
    using All = Effects<E...>;
    using Packed = pass_detail::Packed<Smoothing, All>;
    static_assert(has_all<Sources>(Packed{}) &&
                  has_all<Receivers>(pass_detail::OfReceiver<Smoothing, All>{}) &&
                  has_all<Receivers>(typename All::Stored{}));
    if (sources.size() != neighbours.searched() || receivers.size() != neighbours.receivers().size())
        throw std::logic_error{"sum_over_neighbours: not the particles whose neighbours were found"};
    using Pass = pass_detail::Sum<N::d, Smoothing, All>;
    pass_detail::pack(view_of<const double*>(sources, Packed{}), neighbours);
    const Pass pass{view_of<const double*>(receivers, typename Pass::Read{}),
                    view_of<double*>(receivers, typename Pass::Write{}), smoothing, effects};
    NeighbourList<N::d>& list = neighbours;
    std::atomic<std::size_t> visited{0};
    list.team().parallel_for(
        list.receivers().size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
            constexpr std::size_t interruptible = 4096;  // receivers between two looks for Ctrl-C
            for (std::size_t next = begin; begin < end; begin = next) {
                next = std::min(end, begin + interruptible);
                app::check_interrupt();
                if constexpr (pass_detail::all_inlined) {
                    visited += pass_detail::sum_receivers_inlined(pass, list, begin, next, part);
                } else {
                    visited += pass_detail::sum_receivers(pass, list, begin, next, part);
                }
            }
        });
    const auto pairs = static_cast<long>(visited);
    Counters& counters = neighbours.counters();
    ++counters.passes;
    counters.pairs += pairs;
    counters.evaluations += pairs * static_cast<long>(All::pairwise());
}

/// The same for particles among themselves.
template <class P, class N, class Smoothing, class... E>
void sum_over_neighbours(P& particles, N& neighbours, const Smoothing& smoothing,
                         const Effects<E...>& effects) {
    sum_over_neighbours(particles, particles, neighbours, smoothing, effects);
}

}  // namespace sph
