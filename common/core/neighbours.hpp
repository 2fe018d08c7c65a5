#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "common/core/boundary.hpp"
#include "common/core/neighbour_list.hpp"

namespace sph {

/// Finds the neighbours of particles in a space that ends as Boundary says. One object serves a whole run:
/// after the first steps it allocates nothing.
template <int dimension, class Boundary = Free>
class Neighbours : public NeighbourList<dimension> {
    using List = NeighbourList<dimension>;

  public:
    static constexpr int d = dimension;

    explicit Neighbours(Boundary boundary = {}, int threads = 1)
        : List{threads}, boundary_{std::move(boundary)} {}
    const Boundary& boundary() const noexcept { return boundary_; }

    /// Finds, for each of the points x, those of x within reach (itself included). `reach`: one value, or one
    /// a point, >= 0. Throws std::invalid_argument for a coordinate or reach that is not finite, naming the
    /// point. Cost: sorting, 20-40 ns a point, and with Keep::list 1-4 ns a neighbour.
    void find(const Columns<d>& x, std::span<const double> reach, Support support = Support::gather,
              Keep keep = Keep::list) {
        place_sources(x, reach);
        this->receive_particles(reach);
        this->list_neighbours(support, keep);
    }
    void find(const Columns<d>& x, double reach, Support support = Support::gather, Keep keep = Keep::list) {
        find(x, std::span{&reach, 1}, support, keep);
    }

    /// Finds for each of the points `at` those of x within `reach` (one value, or one a point of `at`): for
    /// interpolating at any position. The points themselves are not neighbours of each other.
    /// Throws as find() does. Behind a mirror a point sees what its reach leaves of the images: keep it
    /// inside.
    void find_around(const Columns<d>& at, std::span<const double> reach, const Columns<d>& x,
                     Keep keep = Keep::list) {
        Cells<d>::require_sound(at, reach);
        double largest = 0;
        for (const double r : reach) largest = std::max(largest, r);
        place_sources(x, std::span{&largest, 1});
        this->receivers_.clear();
        for (std::size_t i = 0; i < at[0].size(); ++i) {
            Vector<d> position;
            for (std::size_t a = 0; a < d; ++a) position[a] = at[a][i];
            boundary_.wrap(position);
            this->receivers_.push_back(
                {static_cast<std::uint32_t>(i), position, reach[reach.size() == 1 ? 0 : i]});
        }
        this->list_neighbours(Support::gather, keep);
    }

  private:
    /// Brings the particles into the box, adds their ghosts, and sorts both by cell.
    void place_sources(const Columns<d>& x, std::span<const double> reach) {
        this->take_sources(x, reach);
        const auto wrap = [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Vector<d> position;
                for (std::size_t a = 0; a < d; ++a) position[a] = this->sources_[a][i];
                boundary_.wrap(position);
                for (std::size_t a = 0; a < d; ++a) this->sources_[a][i] = position[a];
            }
        };
        this->team_.parallel_for(this->count_, wrap, List::light_grain);
        boundary_.add_ghosts(this->sources_, this->largest_reach(), this->ghosts_);
        this->sort_sources(reach);
    }

    Boundary boundary_;
};

}  // namespace sph
