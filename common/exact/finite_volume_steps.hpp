#pragma once
#include <cstddef>

#include "common/exact/finite_volume.hpp"

/// What the solvers in one and two dimensions share: how they step, and what lies beyond an end.
namespace exact::steps {

inline constexpr const char* problem = "finite-volume solver";
/// A face that would hold less than this part of its cell's density or pressure is not positive enough.
inline constexpr double least = 1e-3;
/// The states of a jump at the start are no measure of the waves to come: the first steps are shorter.
/// Source: Toro (2009), section 6.4.
inline constexpr int slow_steps = 5;
inline constexpr double slow_start = 0.25;  ///< of the Courant number
/// Repeats of a step: down to a thousandth of its length.
inline constexpr int most_repeats = 10;

/// Of the last cell before an end, its mirror image and the cell at the other end: which the ghost shows.
inline std::size_t shown(End end, std::size_t last, std::size_t mirror, std::size_t other) {
    if (end == End::transmissive) return last;
    return end == End::reflecting ? mirror : other;
}

}  // namespace exact::steps
