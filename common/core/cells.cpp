#include "common/core/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace sph {
namespace {

/// Cells a reach along x, where narrow ones cost nothing, and along y and z, where each is a run of its own.
constexpr double cells_along_row(int d) {
    return d == 1 ? 8 : 4;
}

Tile load(const Column& column, std::size_t k) {
    return Tile::load(column.data() + k);
}

void require(bool sound, const char* what, std::size_t i) {
    if (!sound)
        throw std::invalid_argument{std::string{what} + " of point " + std::to_string(i) +
                                    " is not a number of reasonable size"};
}
constexpr double too_large = 1e150;
constexpr int most_grids = 32;          // the last one takes all smaller reaches
constexpr std::size_t grain = 1 << 13;  // points for which waking a thread pays

template <int d>
Vector<d> at(const Columns<d>& x, std::size_t i) {
    Vector<d> position;
    for (std::size_t a = 0; a < d; ++a) position[a] = x[a][i];
    return position;
}

}  // namespace

template <int d>
long Cells<d>::Grid::cell(double coordinate, std::size_t axis) const {
    const double c = (coordinate - low[axis]) * per_width[axis];
    return static_cast<long>(std::clamp(c, 0.0, static_cast<double>(count[axis] - 1)));
}

template <int d>
std::size_t Cells<d>::Grid::flat(const Vector<d>& x) const {
    long index = 0;
    for (std::size_t a = d; a-- > 0;) index = index * count[a] + cell(x[a], a);
    return static_cast<std::size_t>(index);
}

/// Chooses the cells of a grid whose points, reach and corners are known.
template <int d>
void Cells<d>::lay_out(Grid& grid) {
    double largest = grid.reach;
    for (std::size_t a = 0; a < d; ++a)
        largest = std::max({largest, std::abs(grid.low[a]), std::abs(grid.high[a])});
    // Coordinates are rounded, and so are their differences: what rounding may move is searched too.
    grid.margin = 16 * std::numeric_limits<double>::epsilon() * largest;
    double width = std::max({grid.reach, grid.margin, 1 / too_large});
    const auto lay = [&] {
        double cells = 1;
        for (std::size_t a = 0; a < d; ++a) {
            grid.width[a] = a == 0 ? width / cells_along_row(d) : width;
            cells *= 1 + std::floor((grid.high[a] - grid.low[a]) / grid.width[a]);
        }
        return cells;
    };
    while (lay() > 4.0 * static_cast<double>(grid.points) + 64) width *= 2;
    for (std::size_t a = 0; a < d; ++a) {
        grid.per_width[a] = 1 / grid.width[a];
        grid.count[a] = 1 + static_cast<long>((grid.high[a] - grid.low[a]) * grid.per_width[a]);
    }
}

template <int d>
void Cells<d>::require_sound(const Columns<d>& x, std::span<const double> reach) {
    const std::size_t n = x[0].size();
    for (const Column& column : x) {
        if (column.size() != n) throw std::invalid_argument{"columns of different length"};
    }
    if (n >= std::numeric_limits<std::uint32_t>::max()) throw std::invalid_argument{"too many points"};
    if (reach.size() != 1 && reach.size() != n) throw std::invalid_argument{"one reach, or one a point"};
    for (std::size_t i = 0; i < reach.size(); ++i)
        require(reach[i] >= 0 && reach[i] < too_large, "the reach", i);
    for (const Column& column : x) {
        int wrong = 0;
        for (const double coordinate : column) wrong |= std::abs(coordinate) < too_large ? 0 : 1;
        if (wrong == 0) continue;
        for (std::size_t i = 0; i < n; ++i) require(std::abs(column[i]) < too_large, "a coordinate", i);
    }
}

/// Decides which grid each point belongs to.
template <int d>
std::size_t Cells<d>::choose_grids(std::size_t points, std::span<const double> reach) {
    const double largest = reach.empty() ? 0 : *std::max_element(reach.begin(), reach.end());
    equal_reaches_ = std::all_of(reach.begin(), reach.end(), [&](double value) { return value == largest; });
    grid_of_.assign(points, 0);
    if (equal_reaches_) return 1;
    for (std::size_t i = 0; i < points; ++i) {
        const double ratio = largest / std::max(reach[i], 1 / too_large);
        grid_of_[i] = static_cast<std::uint8_t>(std::clamp(std::ilogb(ratio), 0, most_grids - 1));
    }
    return most_grids;
}

template <int d>
void Cells<d>::Grid::include(const Vector<d>& x, double point_reach) {
    ++points;
    reach = std::max(reach, point_reach);
    for (std::size_t a = 0; a < d; ++a) {
        low[a] = std::min(low[a], x[a]);
        high[a] = std::max(high[a], x[a]);
    }
}
template <int d>
void Cells<d>::Grid::include(const Grid& other) {
    points += other.points;
    reach = std::max(reach, other.reach);
    for (std::size_t a = 0; a < d; ++a) {
        low[a] = std::min(low[a], other.low[a]);
        high[a] = std::max(high[a], other.high[a]);
    }
}

/// Finds the extent of each grid, drops empty ones, and lays out the cells; returns how many there are.
template <int d>
std::size_t Cells<d>::make_grids(const Columns<d>& x, std::span<const double> reach, app::Team& team) {
    const std::size_t n = x[0].size(), count = choose_grids(n, reach);
    const auto parts = static_cast<std::size_t>(team.size());
    grids_.assign(count * parts, Grid{});
    team.parallel_for(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t part) {
            std::array<Grid, most_grids> grids;  // the thread's own, so that it shares no cache line
            for (std::size_t i = begin; i < end; ++i)
                grids[grid_of_[i]].include(at(x, i), reach[reach.size() == 1 ? 0 : i]);
            std::copy(grids.begin(), grids.begin() + static_cast<std::ptrdiff_t>(count),
                      grids_.begin() + static_cast<std::ptrdiff_t>(part * count));
        },
        grain);
    for (std::size_t part = 1; part < parts; ++part) {
        for (std::size_t g = 0; g < count; ++g) grids_[g].include(grids_[part * count + g]);
    }
    std::array<std::uint8_t, most_grids> place{};
    std::size_t used = 0;
    for (std::size_t g = 0; g < count; ++g) {
        place[g] = static_cast<std::uint8_t>(used);
        if (grids_[g].points > 0) grids_[used++] = grids_[g];
    }
    grids_.resize(used);
    if (used > 1) {
        for (std::uint8_t& g : grid_of_) g = place[g];
    } else {
        std::fill(grid_of_.begin(), grid_of_.end(), std::uint8_t{0});
    }
    std::size_t cells = 0;
    for (Grid& grid : grids_) {
        lay_out(grid);
        grid.first_cell = cells;
        cells += grid.cells();
    }
    return cells;
}

template <int d>
void Cells<d>::sort(const Columns<d>& x, std::span<const double> reach, app::Team& team) {
    require_sound(x, reach);
    const std::size_t n = x[0].size(), cells = make_grids(x, reach, team);
    // Counting sort, each part of the team with counts of its own. It is stable: the order within a cell is
    // the caller's, and results depend neither on the machine nor on the number of threads.
    const auto parts = static_cast<std::size_t>(team.size());
    cell_.resize(n);
    next_.assign(parts * cells, 0);
    team.parallel_for(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t part) {
            for (std::size_t i = begin; i < end; ++i) {
                const Grid& grid = grids_[grid_of_[i]];
                cell_[i] = static_cast<std::uint32_t>(grid.first_cell + grid.flat(at(x, i)));
                ++next_[part * cells + cell_[i]];
            }
        },
        grain);
    start_.resize(cells + 1);
    std::uint32_t total = 0;
    for (std::size_t c = 0; c < cells; ++c) {
        start_[c] = total;
        for (std::size_t part = 0; part < parts; ++part)
            total += std::exchange(next_[part * cells + c], total);
    }
    start_[cells] = total;
    order_.resize(n);
    for (Column& column : x_) column.resize(n + tile_width);
    reach2_.resize(equal_reaches_ ? 0 : n + tile_width);
    team.parallel_for(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t part) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t k = next_[part * cells + cell_[i]]++;
                order_[k] = static_cast<std::uint32_t>(i);
                for (std::size_t a = 0; a < d; ++a) x_[a][k] = x[a][i];
                if (!equal_reaches_) reach2_[k] = reach[i] * reach[i];
            }
        },
        grain);
}

template <int d>
template <class Visit>
void Cells<d>::for_each_row(const Vector<d>& x, double reach, Support support, Visit&& visit) const {
    for (const Grid& grid : grids_) {
        const double s = (support == Support::symmetric ? std::max(reach, grid.reach) : reach) + grid.margin;
        // Cells along an axis that a sphere of radius s around x may touch, and how near the edge of one is.
        const auto range = [&](std::size_t a, double half) {
            return std::pair{grid.cell(x[a] - half, a), grid.cell(x[a] + half, a)};
        };
        const auto distance = [&](std::size_t a, long cell) {
            const double low = grid.low[a] + static_cast<double>(cell) * grid.width[a];
            return std::max({0.0, low - x[a], x[a] - low - grid.width[a]});
        };
        const auto row = [&](long j, long k, double left) {
            const auto [first, last] = range(0, left);
            const auto cell =
                grid.first_cell + static_cast<std::size_t>((k * grid.count[1] + j) * grid.count[0] + first);
            const std::size_t begin = start_[cell],
                              end = start_[cell + static_cast<std::size_t>(last - first) + 1];
            if (begin < end) visit(begin, end);
        };
        if constexpr (d == 1) {
            row(0, 0, s);
        } else {
            const auto [first_k, last_k] = d == 3 ? range(d - 1, s) : std::pair{0L, 0L};
            const auto [first_j, last_j] = range(1, s);
            for (long k = first_k; k <= last_k; ++k) {
                const double z = d == 3 ? distance(d - 1, k) : 0.0;
                for (long j = first_j; j <= last_j; ++j) {
                    const double y = distance(1, j);
                    const double left2 = s * s - y * y - z * z;
                    if (left2 >= 0) row(j, k, std::sqrt(left2) + grid.margin);
                }
            }
        }
    }
}

template <int d>
void Cells<d>::append_neighbours(const Vector<d>& x, double reach, Support support, Indices& found) const {
    const bool own = support == Support::symmetric && !equal_reaches_;
    const double widest = support == Support::symmetric && equal_reaches_ && !grids_.empty()
                              ? std::max(reach, grids_[0].reach)
                              : reach;
    const Tile limit = widest * widest;
    for_each_row(x, reach, support, [&](std::size_t begin, std::size_t end) {
        std::uint32_t* const start = found.room(end - begin + tile_width);
        std::uint32_t* out = start;
        for (std::size_t k = begin; k < end; k += tile_width) {
            Tile r2 = (x[0] - load(x_[0], k)).square();
            for (std::size_t a = 1; a < d; ++a) r2 += (x[a] - load(x_[a], k)).square();
            const Tile within = own ? limit.max(load(reach2_, k)) : limit;
            out += write_below(r2, within, static_cast<std::uint32_t>(k), std::min(end - k, tile_width), out);
        }
        found.add(static_cast<std::size_t>(out - start));
    });
}

template <int d>
std::size_t Cells<d>::candidates(const Vector<d>& x, double reach, Support support) const {
    std::size_t count = 0;
    for_each_row(x, reach, support, [&](std::size_t begin, std::size_t end) { count += end - begin; });
    return count;
}

template class Cells<1>;
template class Cells<2>;
template class Cells<3>;

}  // namespace sph
