#pragma once

namespace bench {

/// What this core can do at most, measured: double-precision operations a second of independent fused
/// multiply-adds in registers, and bytes a second of a[i] = b[i] + s c[i] over arrays far larger than the
/// caches (three arrays of 64 MiB; `quick`: 16 MiB).
struct Peaks {
    double flops = 0, bytes = 0;
};
Peaks measure_peaks(bool quick);

}  // namespace bench
