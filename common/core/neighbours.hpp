#pragma once
#include <cstdint>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "common/app/program.hpp"
#include "common/app/team.hpp"
#include "common/core/boundary.hpp"
#include "common/core/cells.hpp"
#include "common/core/counters.hpp"
#include "common/core/row_buffer.hpp"

namespace sph {

/// Whether find() writes every particle's neighbours down, or each pass looks for them anew. A list costs
/// memory (four bytes a neighbour) and is faster as soon as there are two passes.
enum class Keep { list, nothing };

/// The neighbours of particles, and what several passes over them share: ghosts, the order of the cells,
/// threads, counters and scratch memory. One object serves a whole run: after the first steps it allocates
/// nothing.
template <int dimension, class Boundary = Free>
class Neighbours {
  public:
    static constexpr int d = dimension;

    explicit Neighbours(Boundary boundary = {}, int threads = 1)
        : boundary_{std::move(boundary)}, team_{threads}, parts_(static_cast<std::size_t>(team_.size())) {}

    /// Finds, for each of the points x, those of x within reach (itself included). `reach`: one value, or one
    /// a point, >= 0. Throws std::invalid_argument for a coordinate or reach that is not finite, naming the
    /// point. Cost: sorting, 20-40 ns a point, and with Keep::list 1-4 ns a neighbour.
    void find(const Columns<d>& x, std::span<const double> reach, Support support = Support::gather,
              Keep keep = Keep::list) {
        sort_sources(x, reach);
        receive_particles(reach);
        list_neighbours(support, keep);
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
        sort_sources(x, std::span{&largest, 1});
        receivers_.clear();
        for (std::size_t i = 0; i < at[0].size(); ++i) {
            Vector<d> position;
            for (std::size_t a = 0; a < d; ++a) position[a] = at[a][i];
            boundary_.wrap(position);
            receivers_.push_back({static_cast<std::uint32_t>(i), position, reach[reach.size() == 1 ? 0 : i]});
        }
        list_neighbours(Support::gather, keep);
    }

    /// Points whose neighbours were found, in the order in which passes visit them.
    struct Receiver {
        std::uint32_t index;  ///< in the caller's order
        Vector<d> x;          ///< brought into the box
        double reach;
    };
    std::span<const Receiver> receivers() const noexcept { return receivers_; }
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
    const Cells<d>& cells() const noexcept { return cells_; }
    const Boundary& boundary() const noexcept { return boundary_; }
    Support support() const noexcept { return support_; }
    double largest_reach() const noexcept { return largest_reach_; }

    /// Pairs (i, j) that were found, each in both directions, and each particle with itself.
    std::size_t pairs() const noexcept { return pairs_; }

    app::Team& team() noexcept { return team_; }
    Counters& counters() noexcept { return counters_; }
    RowBuffer& rows() noexcept { return rows_; }
    Indices& scratch(std::size_t part) noexcept { return parts_[part].found; }

  private:
    static constexpr std::size_t light_grain = 1 << 13;  // points for which waking a thread pays
    struct Run {
        std::size_t begin, end, receiver;  // sources, and the place of the first particle among them
    };
    struct Place {
        const Indices* part;
        std::size_t first, count;
    };

    void sort_sources(const Columns<d>& x, std::span<const double> reach);
    void receive_particles(std::span<const double> reach);
    std::size_t append(std::size_t r, Indices& found) const;
    void list_neighbours(Support support, Keep keep);

    Boundary boundary_;
    app::Team team_;
    struct alignas(128) Part {  // each on cache lines of its own: threads write to theirs all the time
        Indices found;
    };
    std::vector<Part> parts_;  // one a thread: its receivers' neighbours, or scratch
    Cells<d> cells_;
    Columns<d> sources_;
    Column source_reach_;
    std::vector<Ghost<d>> ghosts_;
    std::size_t count_ = 0;  // of sources that are particles
    double largest_reach_ = 0;
    std::vector<Run> runs_;
    std::vector<Receiver> receivers_;
    std::vector<Place> places_;
    Support support_ = Support::gather;
    Keep keep_ = Keep::list;
    std::size_t pairs_ = 0;
    Counters counters_;
    RowBuffer rows_;
};

template <int dimension, class Boundary>
void Neighbours<dimension, Boundary>::sort_sources(const Columns<d>& x, std::span<const double> reach) {
    app::check_interrupt();
    count_ = x[0].size();
    largest_reach_ = 0;
    for (const double r : reach) largest_reach_ = std::max(largest_reach_, r);
    for (std::size_t a = 0; a < d; ++a) {
        if (x[a].size() != count_) throw std::invalid_argument{"columns of different length"};
        sources_[a].resize(count_);
    }
    const auto wrap = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vector<d> position;
            for (std::size_t a = 0; a < d; ++a) position[a] = x[a][i];
            boundary_.wrap(position);
            for (std::size_t a = 0; a < d; ++a) sources_[a][i] = position[a];
        }
    };
    team_.parallel_for(count_, wrap, light_grain);
    ghosts_.clear();
    boundary_.add_ghosts(sources_, largest_reach_, ghosts_);
    for (std::size_t a = 0; a < d; ++a) {
        for (const Ghost<d>& ghost : ghosts_) sources_[a].push_back(ghost.x[a]);
    }
    if (reach.size() == 1) return cells_.sort(sources_, reach, team_);
    source_reach_.assign(reach.begin(), reach.end());
    for (const Ghost<d>& ghost : ghosts_) source_reach_.push_back(reach[ghost.owner]);
    cells_.sort(sources_, source_reach_, team_);
}

/// All particles among the sources, in the order of the blocks of cells.
template <int dimension, class Boundary>
void Neighbours<dimension, Boundary>::receive_particles(std::span<const double> reach) {
    runs_.clear();
    std::size_t first = 0;
    cells_.for_each_block_run([&](std::size_t begin, std::size_t end) {
        runs_.push_back({begin, end, first});
        for (std::size_t k = begin; k < end; ++k) first += cells_.order()[k] < count_ ? 1 : 0;
    });
    receivers_.resize(count_);
    const auto receive = [&](std::size_t first_run, std::size_t last_run) {
        for (std::size_t run = first_run; run < last_run; ++run) {
            std::size_t r = runs_[run].receiver;
            for (std::size_t k = runs_[run].begin; k < runs_[run].end; ++k) {
                const std::uint32_t i = cells_.order()[k];
                if (i < count_) receivers_[r++] = {i, cells_.position(k), reach[reach.size() == 1 ? 0 : i]};
            }
        }
    };
    team_.parallel_for(runs_.size(), receive, light_grain / 16);
}

/// Appends the neighbours of the r-th receiver, padded, and returns how many they are without padding.
template <int dimension, class Boundary>
std::size_t Neighbours<dimension, Boundary>::append(std::size_t r, Indices& found) const {
    const std::size_t before = found.size();
    cells_.append_neighbours(receivers_[r].x, receivers_[r].reach, support_, found);
    const std::size_t count = found.size() - before;
    const std::size_t whole = (count + tile_width - 1) / tile_width * tile_width;
    std::uint32_t* const end = found.room(tile_width);
    if (count > 0) std::fill(end, end + (whole - count), end[-1]);
    found.add(whole - count);
    return count;
}

template <int dimension, class Boundary>
void Neighbours<dimension, Boundary>::list_neighbours(Support support, Keep keep) {
    support_ = support;
    keep_ = keep;
    pairs_ = 0;
    ++counters_.searches;
    if (keep == Keep::nothing) return;
    places_.resize(receivers_.size());
    for (Part& part : parts_) part.found.clear();
    team_.parallel_for(receivers_.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
        Indices& found = parts_[part].found;
        for (std::size_t r = begin; r < end; ++r) {
            const std::size_t first = found.size();
            places_[r] = {&found, first, append(r, found)};
        }
        found.keep_slack();
    });
    for (const Place& place : places_) pairs_ += place.count;
}

}  // namespace sph
