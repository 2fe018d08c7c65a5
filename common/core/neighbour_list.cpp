#include "common/core/neighbour_list.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/app/program.hpp"

namespace sph {

template <int d>
void NeighbourList<d>::take_sources(const Columns<d>& x, std::span<const double> reach) {
    app::check_interrupt();
    count_ = x[0].size();
    largest_reach_ = 0;
    for (const double r : reach) largest_reach_ = std::max(largest_reach_, r);
    for (std::size_t a = 0; a < d; ++a) {
        if (x[a].size() != count_) throw std::invalid_argument{"columns of different length"};
        sources_[a].assign(x[a].begin(), x[a].end());
    }
    ghosts_.clear();
}

template <int d>
void NeighbourList<d>::sort_sources(std::span<const double> reach) {
    for (std::size_t a = 0; a < d; ++a) {
        for (const Ghost<d>& ghost : ghosts_) sources_[a].push_back(ghost.x[a]);
    }
    if (reach.size() == 1) return cells_.sort(sources_, reach, team_);
    source_reach_.assign(reach.begin(), reach.end());
    for (const Ghost<d>& ghost : ghosts_) source_reach_.push_back(reach[ghost.owner]);
    cells_.sort(sources_, source_reach_, team_);
}

/// All particles among the sources, in the order of the blocks of cells.
template <int d>
void NeighbourList<d>::receive_particles(std::span<const double> reach) {
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
template <int d>
std::size_t NeighbourList<d>::append(std::size_t r, Indices& found) const {
    const std::size_t before = found.size();
    cells_.append_neighbours(receivers_[r].x, receivers_[r].reach, support_, found);
    const std::size_t count = found.size() - before;
    const std::size_t whole = (count + tile_width - 1) / tile_width * tile_width;
    std::uint32_t* const end = found.room(tile_width);
    if (count > 0) std::fill(end, end + (whole - count), end[-1]);
    found.add(whole - count);
    return count;
}

template <int d>
void NeighbourList<d>::list_neighbours(Support support, Keep keep) {
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

template class NeighbourList<1>;
template class NeighbourList<2>;
template class NeighbourList<3>;

}  // namespace sph
