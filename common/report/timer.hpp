#pragma once
#include <functional>

namespace report {

struct Timing {
    double best = 0, median = 0;  ///< CPU seconds of one call
    long calls = 0;               ///< calls in all
};

/// Times `work`: after one call to warm up, `repeats` (>= 1) samples, each of as many calls as fill
/// `seconds_per_sample` (>= 0; at least one call). Best: the least disturbed sample; median: the usual one.
Timing time(const std::function<void()>& work, int repeats = 5, double seconds_per_sample = 0.01);

/// Keeps the compiler from removing the computation of `value`.
template <class T>
inline void keep(const T& value) {
    asm volatile("" : : "r,m"(value) : "memory");
}

}  // namespace report
