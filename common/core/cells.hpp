#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/app/team.hpp"
#include "common/core/indices.hpp"
#include "common/core/vec.hpp"

namespace sph {

/// Which pairs are neighbours: those closer than the receiver's reach (gather), or than the larger of both
/// reaches (symmetric: if i sees j then j sees i, as pair forces need).
enum class Support { gather, symmetric };

/// Points sorted by the cell of a regular grid, for finding all points near a position. Cells are rows along
/// x: the points of neighbouring cells of a row follow each other in memory, so that a search is a few runs
/// over contiguous coordinates, eight at a time.
///
/// Points of very different reach lie in different grids, one for each factor of two (so a few far-reaching
/// points do not make the cells of all others large).
template <int d>
class Cells {
  public:
    /// Sorts the points. `reach`: one value for all, or one a point, >= 0. Coordinates and reaches must be
    /// smaller than 1e150, so that squares of distances are finite.
    /// Throws std::invalid_argument for one that is not (NaN included), naming the point.
    /// Cost: O(points + cells), and at most about four cells a point.
    void sort(const Columns<d>& x, std::span<const double> reach, app::Team& team);

    /// Throws what sort() throws for these points.
    static void require_sound(const Columns<d>& x, std::span<const double> reach);

    std::size_t size() const noexcept { return order_.size(); }
    /// The original index of the k-th point in the sorted order.
    std::span<const std::uint32_t> order() const& noexcept { return order_; }
    void order() && = delete;  // what it refers to would be gone
    Vector<d> position(std::size_t k) const {
        Vector<d> x;
        for (std::size_t a = 0; a < d; ++a) x[a] = x_[a][k];
        return x;
    }

    /// Calls visit(begin, end) on runs of the sorted order that cover all points once, block of cells by
    /// block of cells: points visited one after the other have most neighbours in common, and those of a
    /// block fit in the cache.
    template <class Visit>
    void for_each_block_run(Visit&& visit) const;

    /// Appends the sorted indices of the points within reach of `position`: nearer than `reach`, or if
    /// symmetric, than the point's own reach. In the same order for any number of threads.
    /// Cost: about 3 candidates a neighbour in 3D, 2 in 2D, 1.2 in 1D where reaches are equal.
    void append_neighbours(const Vector<d>& position, double reach, Support support, Indices& found) const;
    /// Candidates that append_neighbours() tests: what a search costs.
    std::size_t candidates(const Vector<d>& position, double reach, Support support) const;

  private:
    /// The grid of the points whose reach is at most `reach` and, but for the last grid, above half of it.
    struct Grid {
        double reach = 0, margin = 0;
        Vector<d> low = filled(infinity), high = filled(-infinity), width{}, per_width{};
        std::array<long, 3> count{1, 1, 1};
        std::size_t points = 0, first_cell = 0;

        void include(const Vector<d>& x, double point_reach);
        void include(const Grid& other);
        long cell(double coordinate, std::size_t axis) const;
        std::size_t flat(const Vector<d>& x) const;
        std::size_t cells() const { return static_cast<std::size_t>(count[0] * count[1] * count[2]); }
    };

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static Vector<d> filled(double value) {
        Vector<d> x;
        for (double& component : x) component = value;
        return x;
    }
    std::size_t choose_grids(std::size_t points, std::span<const double> reach);
    std::size_t make_grids(const Columns<d>& x, std::span<const double> reach, app::Team& team);
    static void lay_out(Grid& grid);
    template <class Visit>
    void for_each_row(const Vector<d>& position, double reach, Support support, Visit&& visit) const;

    std::vector<Grid> grids_;
    bool equal_reaches_ = true;
    std::vector<std::uint8_t> grid_of_;  // of each point
    std::vector<std::uint32_t> cell_, start_, next_, order_;
    Columns<d> x_;   // sorted, with tile_width more that may be read
    Column reach2_;  // the same; empty if all reaches are equal
};
template <int d>
template <class Visit>
void Cells<d>::for_each_block_run(Visit&& visit) const {
    for (const Grid& grid : grids_) {
        const auto& n = grid.count;
        // Cells are a quarter as long along x as across.
        const std::array<long, 3> block{d == 1 ? n[0] : 16, 4, 4};
        for (long k0 = 0; k0 < n[2]; k0 += block[2]) {
            for (long j0 = 0; j0 < n[1]; j0 += block[1]) {
                for (long i0 = 0; i0 < n[0]; i0 += block[0]) {
                    const long end_i = std::min(i0 + block[0], n[0]);
                    for (long k = k0; k < std::min(k0 + block[2], n[2]); ++k) {
                        for (long j = j0; j < std::min(j0 + block[1], n[1]); ++j) {
                            const long row = static_cast<long>(grid.first_cell) + (k * n[1] + j) * n[0];
                            const std::size_t begin = start_[static_cast<std::size_t>(row + i0)];
                            const std::size_t end = start_[static_cast<std::size_t>(row + end_i)];
                            if (begin < end) visit(begin, end);
                        }
                    }
                }
            }
        }
    }
}

extern template class Cells<1>;
extern template class Cells<2>;
extern template class Cells<3>;

}  // namespace sph
