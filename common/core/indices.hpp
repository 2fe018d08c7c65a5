#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#if defined(__AVX512F__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

#include "common/core/tile.hpp"

namespace sph {

/// A growing list of indices, written without a check for each one: room() makes sure of space, then any
/// number up to it is written behind the end, and add() says how many. Keeps its memory when cleared.
class Indices {
  public:
    void clear() noexcept { size_ = 0; }
    std::size_t size() const noexcept { return size_; }
    const std::uint32_t* data() const noexcept { return index_.get(); }
    /// The place behind the last index, with space for `count` more.
    std::uint32_t* room(std::size_t count) {
        // Doubled, and not set to zero: memory that is not written costs nothing.
        if (size_ + count > capacity_) grow(std::max(size_ + count, 2 * capacity_));
        return index_.get() + size_;
    }
    void add(std::size_t count) noexcept { size_ += count; }
    /// Makes sure that a list a little longer than this one needs no new memory.
    void keep_slack() {
        if (size_ + size_ / 8 > capacity_) grow(size_ + size_ / 4);
    }

  private:
    void grow(std::size_t capacity) {
        auto larger = std::unique_ptr<std::uint32_t[]>{new std::uint32_t[capacity]};
        std::copy(index_.get(), index_.get() + size_, larger.get());
        index_ = std::move(larger);
        capacity_ = capacity;
    }
    std::unique_ptr<std::uint32_t[]> index_;
    std::size_t size_ = 0, capacity_ = 0;
};

/// Writes the indices first + k of those lanes k < `lanes` for which r2[k] < limit[k] one after the other
/// from `out` on, and returns how many they are; up to tile_width places behind them may be overwritten.
inline std::size_t write_below(const Tile& r2, const Tile& limit, std::uint32_t first, std::size_t lanes,
                               std::uint32_t* out) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
    __m512d a, b;
    static_assert(sizeof a == sizeof r2);
    __builtin_memcpy(&a, &r2, sizeof a);
    __builtin_memcpy(&b, &limit, sizeof b);
    const unsigned inside = _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ) & ((1U << lanes) - 1U);
    const __m256i index = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)),
                                           _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    // Compressed in a register and stored whole: storing compressed is slow on some processors.
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(inside), index));
    return static_cast<std::size_t>(__builtin_popcount(inside));
#else
    std::size_t count = 0;
    for (std::size_t k = 0; k < lanes; ++k) {  // no branch: which lanes are inside cannot be predicted
        out[count] = first + static_cast<std::uint32_t>(k);
        count += r2[k] < limit[k] ? 1 : 0;
    }
    return count;
#endif
}

}  // namespace sph
