#pragma once
#include <functional>
#include <string>

namespace bench {

/// CPU nanoseconds of one item of work.
struct Speed {
    double best_ns = 0, median_ns = 0;
};

/// Times `work`, which handles `items` items a call, with Google Benchmark: `repetitions` >= 1 runs of at
/// least `seconds` each, the best and the median of them.
Speed measure(const std::string& name, double items, const std::function<void()>& work, int repetitions = 9,
              double seconds = 0.02);

}  // namespace bench
