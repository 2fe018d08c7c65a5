#include "common/report/timer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "common/app/clock.hpp"
#include "common/app/program.hpp"

namespace report {
namespace {

/// CPU seconds of `calls` calls in a row.
double sample(const std::function<void()>& work, long calls) {
    app::check_interrupt();
    const double start = app::thread_cpu_seconds();
    for (long k = 0; k < calls; ++k) work();
    return app::thread_cpu_seconds() - start;
}

}  // namespace

Timing time(const std::function<void()>& work, int repeats, double seconds_per_sample) {
    if (repeats < 1 || !(seconds_per_sample >= 0))
        throw std::invalid_argument{"time: repeats or seconds too small"};
    Timing timing;
    long calls = 1;
    // Warms up, and finds how many calls fill a sample: reading the clock costs as much as a short call.
    while (true) {
        const double seconds = sample(work, calls);
        timing.calls += calls;
        if (seconds >= seconds_per_sample) break;
        const double wanted =
            1.2 * seconds_per_sample / std::max(seconds, 1e-9);  // 1.2: not to fall short again
        calls = static_cast<long>(std::ceil(static_cast<double>(calls) * std::min(wanted, 100.0)));
    }
    std::vector<double> samples;
    for (int k = 0; k < repeats; ++k) {
        samples.push_back(sample(work, calls) / static_cast<double>(calls));
        timing.calls += calls;
    }
    std::sort(samples.begin(), samples.end());
    timing.best = samples.front();
    // Of an even number of samples the mean of the middle two.
    timing.median = (samples[(samples.size() - 1) / 2] + samples[samples.size() / 2]) / 2;
    return timing;
}

}  // namespace report
