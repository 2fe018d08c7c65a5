#include "common/report/timer.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

TEST_CASE("calls are counted and the best is not above the median") {
    // Fails if the warm-up is not counted, or if best and median are swapped.
    long calls = 0;
    double sum = 0;
    const auto work = [&] {
        ++calls;
        for (int k = 0; k < 1000; ++k) sum += std::sqrt(k + sum);
        report::keep(sum);
    };
    for (const int repeats : {1, 2, 5}) {
        calls = 0;
        const auto timing = report::time(work, repeats, 0.001);
        CHECK(timing.calls == calls);
        CHECK(timing.calls > repeats);
        CHECK(timing.best > 0);
        CHECK(timing.best <= timing.median);
    }
}

TEST_CASE("without a demanded length each sample is one call") {
    // Fails if samples are prolonged for nothing: a call may last minutes.
    CHECK(report::time([] {}, 3, 0).calls == 4);
    CHECK_THROWS_AS(report::time([] {}, 0, 0.01), std::invalid_argument);
    CHECK_THROWS_AS(report::time([] {}, 1, -1), std::invalid_argument);
}

TEST_CASE("twice the work takes about twice the time") {
    // Fails if seconds are not divided by the calls of a sample. The bounds are wide: machines are busy.
    double sum = 0;
    const auto work = [&](int count) {
        return [&sum, count] {
            for (int k = 0; k < count; ++k) sum += std::sqrt(k + sum);
            report::keep(sum);
        };
    };
    const double ratio = report::time(work(20000)).best / report::time(work(2000)).best;
    CHECK(ratio > 3);
    CHECK(ratio < 30);
}
