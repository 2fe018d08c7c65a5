#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/core/tile.hpp"

/// Gathering neighbours into tiles. Reading eight neighbours' values from ten columns touches eighty places
/// in memory. So a pass first copies what it needs of each particle into a row; then a neighbour is one or
/// two cache lines, and eight rows become a tile of each quantity by transposing them in registers.
namespace sph {

/// Rows of equal width. Keeps its memory from pass to pass.
class RowBuffer {
  public:
    /// Makes room for `count` rows of `width` numbers.
    void resize(std::size_t count, std::size_t width) {
        // Whole quadruples: they are loaded four numbers at a time.
        stride_ = (width + 3) / 4 * 4;
        const std::size_t lines = (count * stride_ + tile_width - 1) / tile_width;
        if (lines > lines_.size()) lines_.resize(lines + lines / 8);
    }
    double* row(std::size_t k) noexcept { return reinterpret_cast<double*>(lines_.data()) + k * stride_; }
    const double* row(std::size_t k) const noexcept {
        return reinterpret_cast<const double*>(lines_.data()) + k * stride_;
    }
    std::size_t stride() const noexcept { return stride_; }

  private:
    struct alignas(64) Line {
        double number[tile_width];
    };
    std::vector<Line> lines_;
    std::size_t stride_ = 0;
};

namespace transpose_detail {

using Rows = std::array<const double*, tile_width>;

#if defined(__AVX512F__)
// Vectors of the compiler, one register each.
using V8 [[gnu::vector_size(64), gnu::may_alias]] = double;
using V4 [[gnu::vector_size(32), gnu::may_alias, gnu::aligned(8)]] = double;
using V2 [[gnu::vector_size(16), gnu::may_alias, gnu::aligned(8)]] = double;

inline V8 load(const double* a, const double* b) {
    return __builtin_shufflevector(*reinterpret_cast<const V4*>(a), *reinterpret_cast<const V4*>(b), 0, 1, 2,
                                   3, 4, 5, 6, 7);
}
inline V8 load(const double* a, const double* b, const double* c, const double* e) {
    const V4 ab =
        __builtin_shufflevector(*reinterpret_cast<const V2*>(a), *reinterpret_cast<const V2*>(b), 0, 1, 2, 3);
    const V4 ce =
        __builtin_shufflevector(*reinterpret_cast<const V2*>(c), *reinterpret_cast<const V2*>(e), 0, 1, 2, 3);
    return __builtin_shufflevector(ab, ce, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline V8 evens(V8 a, V8 b) {
    return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
inline V8 odds(V8 a, V8 b) {
    return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
inline void put(Tile& tile, V8 value) {
    tile = Tile::load(reinterpret_cast<const double*>(&value));
}

/// tile[c] lane l = row[l][first + c] for c = 0..3. Each register holds four numbers of two rows; the order
/// in which rows are paired makes the lanes come out in order.
inline void transpose_four(const Rows& row, std::size_t first, Tile* tile) {
    const auto at = [&](std::size_t l) { return row[l] + first; };
    const V8 a = load(at(0), at(2)), b = load(at(1), at(3)), c = load(at(4), at(6)), e = load(at(5), at(7));
    const V8 ab02 = evens(a, b), ab13 = odds(a, b), ce02 = evens(c, e), ce13 = odds(c, e);
    put(tile[0], __builtin_shufflevector(ab02, ce02, 0, 1, 4, 5, 8, 9, 12, 13));
    put(tile[1], __builtin_shufflevector(ab13, ce13, 0, 1, 4, 5, 8, 9, 12, 13));
    put(tile[2], __builtin_shufflevector(ab02, ce02, 2, 3, 6, 7, 10, 11, 14, 15));
    put(tile[3], __builtin_shufflevector(ab13, ce13, 2, 3, 6, 7, 10, 11, 14, 15));
}
/// The same for c = 0, 1.
inline void transpose_two(const Rows& row, std::size_t first, Tile* tile) {
    const auto at = [&](std::size_t l) { return row[l] + first; };
    const V8 a = load(at(0), at(2), at(4), at(6)), b = load(at(1), at(3), at(5), at(7));
    put(tile[0], evens(a, b));
    put(tile[1], odds(a, b));
}
#else
// Shorter registers: number by number is as fast as shuffling halves.
inline Tile gathered(const Rows& row, std::size_t c) {
    const std::array number{row[0][c], row[1][c], row[2][c], row[3][c],
                            row[4][c], row[5][c], row[6][c], row[7][c]};
    return Tile::load(number.data());
}
inline void transpose_four(const Rows& row, std::size_t first, Tile* tile) {
    for (std::size_t c = 0; c < 4; ++c) tile[c] = gathered(row, first + c);
}
inline void transpose_two(const Rows& row, std::size_t first, Tile* tile) {
    for (std::size_t c = 0; c < 2; ++c) tile[c] = gathered(row, first + c);
}
#endif

}  // namespace transpose_detail

/// The first `width` numbers of eight rows as `width` tiles.
template <std::size_t width>
std::array<Tile, (width + 3) / 4 * 4> tiles_of(const RowBuffer& rows, const std::uint32_t* index) {
    transpose_detail::Rows row;
    for (std::size_t l = 0; l < tile_width; ++l) row[l] = rows.row(index[l]);
    std::array<Tile, (width + 3) / 4 * 4> tile;
    for (std::size_t c = 0; c + 2 < width; c += 4) transpose_detail::transpose_four(row, c, tile.data() + c);
    constexpr std::size_t rest = width % 4;
    if constexpr (rest == 1 || rest == 2)
        transpose_detail::transpose_two(row, width - rest, tile.data() + (width - rest));
    return tile;
}

}  // namespace sph
