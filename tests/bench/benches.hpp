#pragma once
#include "common/report/chapter.hpp"

/// The micro-benchmarks, one function each; `./tutorial bench NAME` runs one.
namespace bench {

/// The compiler must assume that what `pointer` points to is read and written.
inline void benchmark_keep(const void* pointer) {
    asm volatile("" : : "g"(pointer) : "memory");
}

/// kernels.cpp: nanoseconds a pair of every kernel, and of the cubic spline in five forms.
void kernels(report::Run& run);

}  // namespace bench
