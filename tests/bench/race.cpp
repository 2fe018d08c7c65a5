#include "tests/bench/race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/app/clock.hpp"
#include "common/app/program.hpp"

namespace bench {
namespace {

double now(Clock clock) {
    if (clock == Clock::cpu) return app::thread_cpu_seconds();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds of one of `calls` calls in a row.
double timed(const Runner& runner, long calls, Clock clock) {
    app::check_interrupt();
    const double start = now(clock);
    for (long k = 0; k < calls; ++k) runner.work();
    return (now(clock) - start) / static_cast<double>(calls);
}

}  // namespace

std::vector<Lap> race(const report::Run& run, const std::vector<Runner>& runners, Clock clock) {
    constexpr double least = 0.02;
    const int rounds = run.checking() ? 1 : run.quick() ? 2 : 7;
    std::vector<long> calls(runners.size(), 1);
    for (std::size_t k = 0; k < runners.size() && !run.checking(); ++k) {
        timed(runners[k], 1, clock);
        const double once = std::max(timed(runners[k], 1, clock), 1e-9);
        calls[k] = std::max(1L, std::lround(std::ceil(least / once)));
    }
    std::vector<std::vector<double>> seconds(runners.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t k = 0; k < runners.size(); ++k)
            seconds[k].push_back(timed(runners[k], calls[k], clock));
    }
    std::vector<Lap> laps;
    for (auto& samples : seconds) {
        std::sort(samples.begin(), samples.end());
        laps.push_back({samples.front(), samples[samples.size() / 2]});
    }
    return laps;
}

}  // namespace bench
