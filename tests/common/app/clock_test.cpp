#include "common/app/clock.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <thread>

namespace {

/// Works for so many CPU seconds of this thread.
void work(double seconds) {
    const double start = app::thread_cpu_seconds();
    double sum = 0;
    while (app::thread_cpu_seconds() - start < seconds) {
        for (int k = 0; k < 1000; ++k) sum += std::sqrt(sum + k);
        asm volatile("" : : "r,m"(sum) : "memory");
    }
}

}  // namespace

TEST_CASE("sleep is not CPU time") {
    // Fails if a wall clock is read: other users of the machine would count.
    const double start = app::thread_cpu_seconds(), all = app::process_cpu_seconds();
    std::this_thread::sleep_for(std::chrono::milliseconds{200});
    CHECK(app::thread_cpu_seconds() - start < 0.1);
    CHECK(app::process_cpu_seconds() - all < 0.1);
}

TEST_CASE("a thread's time is its own, a process has that of all") {
    // Fails if the two clocks are exchanged.
    const double mine = app::thread_cpu_seconds(), all = app::process_cpu_seconds();
    std::thread other{[] { work(0.15); }};
    other.join();
    CHECK(app::thread_cpu_seconds() - mine < 0.1);
    CHECK(app::process_cpu_seconds() - all > 0.14);
}
