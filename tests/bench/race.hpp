#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

namespace bench {

/// One way to do a piece of work.
struct Runner {
    std::string name;
    std::function<void()> work;
};

/// Seconds of one call.
struct Lap {
    double best = 0, median = 0;
};

/// CPU seconds of the calling thread, or wall-clock seconds, which is what several threads save.
enum class Clock { cpu, wall };

/// Times all runners in turn, seven times (twice for a quick run), after one round to warm up: what disturbs
/// the machine for a while disturbs them all, and ratios hold. A call shorter than 20 ms is repeated within
/// its turn. Where only the text is being checked, one call each.
std::vector<Lap> race(const report::Run& run, const std::vector<Runner>& runners, Clock clock = Clock::cpu);

}  // namespace bench
