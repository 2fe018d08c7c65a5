#pragma once
#include <array>
#include <cstddef>

#if defined(__AVX__)
#include <immintrin.h>
#endif

/// Eight pairs at a time. A Tile is eight numbers with the arithmetic of one: an equation written for numbers
/// computes eight of them, in registers of the machine's own width (one with AVX-512, two with AVX, else
/// four). A number mixes with tiles as eight copies of itself. What depends on a lane is chosen, not
/// branched: `(r < h).select(a, b)`.
namespace sph {

/// Neighbours are summed this many at a time.
inline constexpr std::size_t tile_width = 8;

namespace tile_detail {

// A register: a vector of the compiler, on which what is written element by element is one instruction. Only
// for the larger of two do compilers need to be told; where one of the two is no number, it is a.
// The sum is (0 + 4) + (2 + 6) + ((1 + 5) + (3 + 7)) for every width.
#if defined(__AVX512F__)
using Numbers [[gnu::vector_size(64)]] = double;
inline Numbers larger(const Numbers& a, const Numbers& b) {
    return _mm512_max_pd(b, a);
}
inline Numbers smaller(const Numbers& a, const Numbers& b) {
    return _mm512_min_pd(b, a);
}
inline double sum(const Numbers* r) {
    const auto four =
        __builtin_shufflevector(r[0], r[0], 0, 1, 2, 3) + __builtin_shufflevector(r[0], r[0], 4, 5, 6, 7);
    const auto two = __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
    return two[0] + two[1];
}
#elif defined(__AVX__)
using Numbers [[gnu::vector_size(32)]] = double;
inline Numbers larger(const Numbers& a, const Numbers& b) {
    return _mm256_max_pd(b, a);
}
inline Numbers smaller(const Numbers& a, const Numbers& b) {
    return _mm256_min_pd(b, a);
}
inline double sum(const Numbers* r) {
    const Numbers four = r[0] + r[1];
    const auto two = __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
    return two[0] + two[1];
}
#else
using Numbers [[gnu::vector_size(16)]] = double;
inline Numbers larger(const Numbers& a, const Numbers& b) {
    return b > a ? b : a;
}
inline Numbers smaller(const Numbers& a, const Numbers& b) {
    return b < a ? b : a;
}
inline double sum(const Numbers* r) {
    const Numbers two = (r[0] + r[2]) + (r[1] + r[3]);
    return two[0] + two[1];
}
#endif
using Bits = decltype(Numbers{} < Numbers{});
inline constexpr std::size_t registers = tile_width * sizeof(double) / sizeof(Numbers);
inline constexpr std::size_t lanes = tile_width / registers;  // of a register

}  // namespace tile_detail

class Tile {
  public:
    Tile() = default;  // zeros
    /// Eight times the same number.
    Tile(double number) {  // NOLINT(google-explicit-constructor)
        for (Numbers& r : register_) r = number - Numbers{};
    }
    static Tile Constant(double number) { return number; }
    /// Eight numbers that lie one after the other, wherever they begin.
    static Tile load(const double* numbers) {
        Tile tile;
        __builtin_memcpy(tile.register_, numbers, sizeof(Tile));
        return tile;
    }
    void store(double* numbers) const { __builtin_memcpy(numbers, register_, sizeof(Tile)); }
    /// The number in one lane. For tests and messages: a lane at a time is slow.
    double operator[](std::size_t lane) const {
        return register_[lane / tile_detail::lanes][lane % tile_detail::lanes];
    }

    /// Where a comparison of two tiles holds, lane by lane.
    class Mask {
      public:
        /// a where it holds, b elsewhere.
        Tile select(const Tile& a, const Tile& b) const {
            Tile chosen;
            for (std::size_t k = 0; k < tile_detail::registers; ++k)
                chosen.register_[k] = bits_[k] ? a.register_[k] : b.register_[k];
            return chosen;
        }
        friend Mask operator&(const Mask& a, const Mask& b) {
            Mask both;
            for (std::size_t k = 0; k < tile_detail::registers; ++k) both.bits_[k] = a.bits_[k] & b.bits_[k];
            return both;
        }

      private:
        friend class Tile;
        tile_detail::Bits bits_[tile_detail::registers]{};
    };

    Tile operator-() const {
        return each([](const Numbers& a) { return -a; });
    }
    friend Tile operator+(const Tile& a, const Tile& b) {
        return each(a, b, [](const Numbers& x, const Numbers& y) { return x + y; });
    }
    friend Tile operator-(const Tile& a, const Tile& b) {
        return each(a, b, [](const Numbers& x, const Numbers& y) { return x - y; });
    }
    friend Tile operator*(const Tile& a, const Tile& b) {
        return each(a, b, [](const Numbers& x, const Numbers& y) { return x * y; });
    }
    friend Tile operator/(const Tile& a, const Tile& b) {
        return each(a, b, [](const Numbers& x, const Numbers& y) { return x / y; });
    }
    Tile& operator+=(const Tile& other) { return *this = *this + other; }
    Tile& operator-=(const Tile& other) { return *this = *this - other; }
    Tile& operator*=(const Tile& other) { return *this = *this * other; }
    Tile& operator/=(const Tile& other) { return *this = *this / other; }

    friend Mask operator<(const Tile& a, const Tile& b) {
        return compare(a, b, [](const Numbers& x, const Numbers& y) { return x < y; });
    }
    friend Mask operator<=(const Tile& a, const Tile& b) {
        return compare(a, b, [](const Numbers& x, const Numbers& y) { return x <= y; });
    }
    friend Mask operator>(const Tile& a, const Tile& b) { return b < a; }
    friend Mask operator>=(const Tile& a, const Tile& b) { return b <= a; }

    // Where one of the two is no number, the result is *this.
    Tile max(const Tile& other) const { return each(*this, other, tile_detail::larger); }
    Tile min(const Tile& other) const { return each(*this, other, tile_detail::smaller); }
    Tile abs() const {
        return each([](const Numbers& x) {
            return reinterpret_cast<Numbers>(reinterpret_cast<tile_detail::Bits>(x) & 0x7fffffffffffffffL);
        });
    }
    // As the standard library has them for numbers.
    friend Tile abs(const Tile& tile) { return tile.abs(); }
    friend Tile sqrt(const Tile& tile) { return tile.sqrt(); }
    friend Tile exp(const Tile& tile) { return tile.exp(); }
    friend Tile log(const Tile& tile) { return tile.log(); }
    Tile square() const { return *this * *this; }
    Tile inverse() const { return 1.0 / *this; }
    Tile sqrt() const {
        return each([](const Numbers& x) {
            Numbers root = x;
            for (std::size_t l = 0; l < tile_detail::lanes; ++l) root[l] = __builtin_sqrt(x[l]);
            return root;
        });
    }
    /// To two units of the last digit; 0 below -708, infinite above 709.43.
    Tile exp() const;

    /// To two units of the last digit or, near 1, of x - 1; for normal numbers > 0.
    Tile log() const;

    /// Of all lanes, in an order that does not depend on the width of a register.
    double sum() const { return tile_detail::sum(register_); }
    /// The largest number of all lanes.
    double maxCoeff() const {
        double largest = (*this)[0];
        for (std::size_t l = 1; l < tile_width; ++l) largest = (*this)[l] > largest ? (*this)[l] : largest;
        return largest;
    }

  private:
    using Numbers = tile_detail::Numbers;
    template <class Function>
    Tile each(Function function) const {
        Tile result;
        for (std::size_t k = 0; k < tile_detail::registers; ++k) result.register_[k] = function(register_[k]);
        return result;
    }
    template <class Function>
    static Tile each(const Tile& a, const Tile& b, Function function) {
        Tile result;
        for (std::size_t k = 0; k < tile_detail::registers; ++k)
            result.register_[k] = function(a.register_[k], b.register_[k]);
        return result;
    }
    template <class Function>
    static Mask compare(const Tile& a, const Tile& b, Function function) {
        Mask mask;
        for (std::size_t k = 0; k < tile_detail::registers; ++k)
            mask.bits_[k] = function(a.register_[k], b.register_[k]);
        return mask;
    }

    Numbers register_[tile_detail::registers]{};
};

/// exp x = 2^n exp r with |r| <= ln 2/2, and exp r = 1 + 2 r P(r^2)/(Q(r^2) - r P(r^2)) (Moshier, Cephes,
/// exp.c).
inline Tile Tile::exp() const {
    constexpr double shift = 0x1.8p52;  // to a number this large, x/ln 2 is added as a whole one
    constexpr double ln2 = 0x1.62e4p-1, ln2_rest = 0x1.7f7d1cf79abcap-20;  // in two parts, the first exact
    constexpr double lowest = -708, highest = 709.8;
    const Tile x = this->max(lowest).min(highest), shifted = x * 1.4426950408889634 + shift,
               n = shifted - shift;
    const Tile r = (x - n * ln2) - n * ln2_rest, r2 = r * r;
    const Tile P = r * ((1.26177193074810590878e-4 * r2 + 3.02994407707441961300e-2) * r2 + 1.0);
    const Tile Q =
        ((3.00198505138664455042e-6 * r2 + 2.52448340349684104192e-3) * r2 + 2.27265548208155028766e-1) * r2 +
        2.0;
    const Tile power = shifted.each([](const Numbers& s) {
        return reinterpret_cast<Numbers>((reinterpret_cast<tile_detail::Bits>(s) + 1023) << 52);
    });
    return (*this < lowest).select(0.0, (1.0 + 2.0 * P / (Q - P)) * power);
}

/// x = 2^n m with m in [sqrt(1/2), sqrt 2), and log m = 2 artanh s = 2 (s + s^3/3 + ...), s = (m - 1)/(m +
/// 1).
inline Tile Tile::log() const {
    using tile_detail::Bits;
    constexpr long mantissa = 0xfffffffffffffL, half = 0x3fe0000000000000L, whole = 0x4330000000000000L;
    constexpr double ln2 = 0x1.62e4p-1, ln2_rest = 0x1.7f7d1cf79abcap-20;  // in two parts, the first exact
    Tile n = each([](const Numbers& x) {  // as the last bits of a number of 2^52 and more
        return reinterpret_cast<Numbers>(((reinterpret_cast<Bits>(x) >> 52) & 0x7ff) | whole) -
               (0x1p52 + 1022);
    });
    Tile m = each([](const Numbers& x) {
        return reinterpret_cast<Numbers>((reinterpret_cast<Bits>(x) & mantissa) | half);
    });
    const Mask low = m < 0.70710678118654752;
    n = low.select(n - 1.0, n);
    m = low.select(2.0 * m, m);
    const Tile s = (m - 1.0) / (m + 1.0), s2 = s * s;
    Tile series = 1.0 / 21;
    for (int k = 19; k > 1; k -= 2) series = series * s2 + 1.0 / k;
    return n * ln2 + (2.0 * s + (2.0 * s * s2 * series + n * ln2_rest));
}

/// Zero in the first `used` lanes (0..8) and one in the others: a window on a constant table, one load.
inline Tile unused_lanes(std::size_t used) {
    static constexpr std::array<double, 2 * tile_width> table{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    return Tile::load(table.data() + (tile_width - used));
}

}  // namespace sph
