#include "tests/bench/peaks.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "common/app/clock.hpp"
#include "common/core/tile.hpp"
#include "common/report/timer.hpp"

namespace bench {
namespace {

double fma_rate() {
    constexpr std::size_t chains = 12;  // enough to hide the latency of four to five cycles on two units
    constexpr long rounds = 2'000'000;
    std::array<sph::Tile, chains> value;
    value.fill(1.0);
    sph::Tile factor = 0.999999, term = 1e-7;
    double best = 1e300;
    for (int repeat = 0; repeat < 3; ++repeat) {
        report::keep(&factor);
        const double start = app::thread_cpu_seconds();
        for (long round = 0; round < rounds; ++round) {
            for (sph::Tile& chain : value) chain = chain * factor + term;
        }
        report::keep(value.data());
        best = std::min(best, app::thread_cpu_seconds() - start);
    }
    return static_cast<double>(rounds) * chains * sph::tile_width * 2 / best;
}

double triad_rate(bool quick) {
    const std::size_t n = (quick ? 2U : 8U) << 20;
    std::vector<double> a(n, 1.0), b(n, 2.0), c(n, 3.0);
    double best = 1e300;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const double start = app::thread_cpu_seconds();
        for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 1.5 * c[i];
        report::keep(a.data());
        best = std::min(best, app::thread_cpu_seconds() - start);
    }
    return 3 * sizeof(double) * static_cast<double>(n) / best;
}

}  // namespace

Peaks measure_peaks(bool quick) {
    return {fma_rate(), triad_rate(quick)};
}

}  // namespace bench
