#pragma once
#include <vector>

#include "chapters/02_consistency/corrected.hpp"

/// What to do where the neighbours are too few: look farther. Enlarging h for the few particles concerned
/// keeps the accuracy; adding a small number to the matrix (Tikhonov) would destroy it for all.
namespace sph {

struct Repairs {
    std::size_t flagged = 0;  ///< particles whose neighbours did not determine a slope
    /// those that even the largest h did not help: their neighbours lie on a line or a point
    std::size_t left = 0;
    double largest_factor = 1;  ///< of h
};

/// Computes the listed effects again for every particle whose Extent is below GuardedSolve::least, with h
/// enlarged by 1.5, 1.5^2, ... up to about 57 until it is not. `estimates(h)` makes the Effects, which must
/// include Extent; `particles` hold their results for `smoothing`. What cannot be helped keeps the guarded
/// result of the h that saw most: no slope along the axis that is not determined. Cost: a sort and a few
/// neighbours for each round; nothing if no particle is concerned.
template <class K, class Scene, class Boundary, class MakeEffects>
Repairs repair(Scene& particles, const Boundary& boundary, const ConstantH<K>& smoothing,
               MakeEffects&& estimates) {
    constexpr int d = Scene::d;
    constexpr double growth = 1.5;
    constexpr int rounds = 10;
    using All = decltype(estimates(smoothing.h));
    using Columns = Union<List<Position>, typename All::ReadI, typename All::Stored>;
    std::vector<std::size_t> flagged;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (!(particles.extent[0][i] >= GuardedSolve::least)) flagged.push_back(i);
    }
    Repairs repairs{.flagged = flagged.size()};
    Neighbours<d, Boundary> neighbours{boundary};
    for (int round = 0; round < rounds && !flagged.empty(); ++round) {
        repairs.largest_factor *= growth;
        const ConstantH<K> larger{repairs.largest_factor * smoothing.h, smoothing.kernel};
        ParticlesOf<d, Columns> points{flagged.size()};
        for (std::size_t k = 0; k < flagged.size(); ++k)
            store<d>(points, k, load<d>(particles, flagged[k], Columns{}));
        neighbours.find_around(points.x, std::array{larger.reach()}, particles.x);
        sum_over_neighbours(points, particles, neighbours, larger, estimates(larger.h));
        std::vector<std::size_t> still;
        for (std::size_t k = 0; k < flagged.size(); ++k) {
            const std::size_t i = flagged[k];
            const bool determined = points.extent[0][k] >= GuardedSolve::least;
            if (!determined) still.push_back(i);
            if (determined || points.extent[1][k] > particles.extent[1][i])
                store<d>(particles, i, load<d>(points, k, typename All::Stored{}));
        }
        flagged = still;
    }
    repairs.left = flagged.size();
    return repairs;
}

}  // namespace sph
