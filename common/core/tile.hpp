#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace sph {

/// Neighbours are summed eight at a time: one register of doubles with AVX-512, two with AVX2.
inline constexpr std::size_t tile_width = 8;
using Tile = Eigen::Array<double, static_cast<int>(tile_width), 1>;

/// Zero in the first `used` lanes (0..8) and one in the others: a window on a constant table, one load.
inline Tile unused_lanes(std::size_t used) {
    static constexpr std::array<double, 2 * tile_width> table{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    return Eigen::Map<const Tile>(table.data() + (tile_width - used));
}

}  // namespace sph
