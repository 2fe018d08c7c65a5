#include "common/report/timer.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "common/app/program.hpp"

namespace report {
namespace {

/// CPU seconds of `calls` calls in a row.
double sample(const std::function<void()>& work, long calls) {
    app::check_interrupt();
    const double start = thread_cpu_seconds();
    for (long k = 0; k < calls; ++k) work();
    return thread_cpu_seconds() - start;
}

}  // namespace

double thread_cpu_seconds() {
    timespec now{};
    if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0)
        throw std::system_error{errno, std::generic_category(), "CPU clock"};
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

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
