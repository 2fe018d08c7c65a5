#pragma once
#include <functional>
#include <string>
#include <vector>

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

/// Times all runners in turn, `rounds` >= 1 times, after one round to warm up: what disturbs the machine for
/// a while disturbs them all, and ratios hold. A call shorter than `least` seconds is repeated within its
/// turn.
std::vector<Lap> race(const std::vector<Runner>& runners, int rounds, Clock clock = Clock::cpu,
                      double least = 0.02);

}  // namespace bench
