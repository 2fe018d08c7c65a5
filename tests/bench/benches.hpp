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
/// pair_loop.cpp: the fused pass beside structures, lists and cells.
void pair_loop_2d(report::Run& run);
void pair_loop_3d(report::Run& run);
/// composition.cpp: what effects cost when listed, when switched off at run time, and when called virtually.
void effects(report::Run& run);
/// neighbours.cpp: what finding neighbours costs.
void neighbours(report::Run& run);
/// scaling.cpp: whole time steps, from a thousand to a million particles, on one thread and two.
void scaling(report::Run& run);

}  // namespace bench
