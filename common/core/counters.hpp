#pragma once

namespace sph {

/// What a run has done: the numbers that explain its seconds and, unlike these, are the same everywhere.
struct Counters {
    long searches = 0;     ///< for neighbours
    long passes = 0;       ///< over all pairs
    long pairs = 0;        ///< (i, j) in these passes, both directions, each particle with itself included
    long evaluations = 0;  ///< of effects, one a pair
    long steps = 0;        ///< of time
};

}  // namespace sph
