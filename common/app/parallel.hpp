#pragma once
#include <cstddef>
#include <functional>

namespace app {

/// Calls body(begin, end) on disjoint parts that cover 0..count, on up to `threads` threads (>= 1); with one
/// thread on the caller's. Which part a thread gets never depends on timing, and as long as element i of the
/// result is computed from inputs alone, the result is bitwise the same for any number of threads.
/// An exception thrown by `body` is thrown again here after all threads have ended.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace app
