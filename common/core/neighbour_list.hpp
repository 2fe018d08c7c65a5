#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "common/app/team.hpp"
#include "common/core/cells.hpp"
#include "common/core/counters.hpp"
#include "common/core/ghost.hpp"
#include "common/core/row_buffer.hpp"

namespace sph {

/// Whether find() writes every particle's neighbours down, or each pass looks for them anew. A list costs
/// memory (four bytes a neighbour) and is faster as soon as there are two passes.
enum class Keep { list, nothing };

/// Who is near whom, and what several passes over these pairs share: ghosts, the order of the cells, threads,
/// counters and scratch memory. Passes know this; what a boundary is they need not know. Filled by
/// Neighbours.
template <int dimension>
class NeighbourList {
  public:
    static constexpr int d = dimension;

    /// Points whose neighbours were found, in the order in which passes visit them.
    struct Receiver {
        std::uint32_t index;  ///< in the caller's order
        Vector<d> x;          ///< brought into the box
        double reach;
    };
    std::span<const Receiver> receivers() const& noexcept { return receivers_; }
    void receivers() && = delete;  // what it refers to would be gone
    /// How many points were searched, ghosts not counted.
    std::size_t searched() const noexcept { return count_; }
    /// Sorted indices of the neighbours of the r-th receiver, followed by the last one repeated up to a
    /// multiple of tile_width. `scratch` is used where no list is kept.
    struct Found {
        const std::uint32_t* index;
        std::size_t count;
    };
    Found of(std::size_t r, Indices& scratch) const {
        if (keep_ == Keep::list) return {places_[r].part->data() + places_[r].first, places_[r].count};
        scratch.clear();
        const std::size_t count = append(r, scratch);
        return {scratch.data(), count};
    }

    /// Sources in sorted order: a particle, or a ghost of one.
    std::size_t sources() const noexcept { return cells_.size(); }
    Vector<d> source_position(std::size_t k) const { return cells_.position(k); }
    std::uint32_t owner(std::size_t k) const {
        const std::uint32_t i = cells_.order()[k];
        return i < count_ ? i : ghosts_[i - count_].owner;
    }
    /// The ghost that the k-th source is, or nullptr for a particle.
    const Ghost<d>* ghost(std::size_t k) const {
        const std::uint32_t i = cells_.order()[k];
        return i < count_ ? nullptr : &ghosts_[i - count_];
    }
    std::size_t ghosts() const noexcept { return ghosts_.size(); }
    const Cells<d>& cells() const& noexcept { return cells_; }
    void cells() && = delete;  // what it refers to would be gone
    Support support() const noexcept { return support_; }
    double largest_reach() const noexcept { return largest_reach_; }

    /// Pairs (i, j) that were found, each in both directions, and each particle with itself.
    std::size_t pairs() const noexcept { return pairs_; }

    app::Team& team() noexcept { return team_; }
    Counters& counters() noexcept { return counters_; }
    RowBuffer& rows() noexcept { return rows_; }
    Indices& scratch(std::size_t part) noexcept { return parts_[part].found; }

  protected:
    explicit NeighbourList(int threads) : team_{threads}, parts_(static_cast<std::size_t>(team_.size())) {}

    // The steps of a search, in this order; the boundary acts between the first two.
    void take_sources(const Columns<d>& x, std::span<const double> reach);
    void sort_sources(std::span<const double> reach);
    void receive_particles(std::span<const double> reach);
    void list_neighbours(Support support, Keep keep);

    static constexpr std::size_t light_grain = 1 << 13;  // points for which waking a thread pays
    app::Team team_;
    Columns<d> sources_;  // the particles, and behind them the ghosts
    std::vector<Ghost<d>> ghosts_;
    std::size_t count_ = 0;  // of sources that are particles
    std::vector<Receiver> receivers_;

  private:
    struct Run {
        std::size_t begin, end, receiver;  // sources, and the place of the first particle among them
    };
    struct Place {
        const Indices* part;
        std::size_t first, count;
    };
    struct alignas(128) Part {  // each on cache lines of its own: threads write to theirs all the time
        Indices found;
    };
    std::size_t append(std::size_t r, Indices& found) const;

    std::vector<Part> parts_;  // one a thread: its receivers' neighbours, or scratch
    Cells<d> cells_;
    Column source_reach_;
    double largest_reach_ = 0;
    std::vector<Run> runs_;
    std::vector<Place> places_;
    Support support_ = Support::gather;
    Keep keep_ = Keep::list;
    std::size_t pairs_ = 0;
    Counters counters_;
    RowBuffer rows_;
};

extern template class NeighbourList<1>;
extern template class NeighbourList<2>;
extern template class NeighbourList<3>;

}  // namespace sph
