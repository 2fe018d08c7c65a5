#include "tests/bench/measure.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

namespace bench {
namespace {

/// Keeps what Google Benchmark would print.
class Collector : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration)
                seconds.push_back(run.cpu_accumulated_time / double(run.iterations));
        }
    }
    std::vector<double> seconds;  // a call
};

}  // namespace

Speed measure(const std::string& name, double items, const std::function<void()>& work, int repetitions,
              double seconds) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&](benchmark::State& state) {
                                     for ([[maybe_unused]] const auto& step : state) work();
                                 })
        ->Repetitions(repetitions)
        ->MinTime(seconds);
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::ClearRegisteredBenchmarks();
    std::sort(collector.seconds.begin(), collector.seconds.end());
    return {collector.seconds.front() / items * 1e9,
            collector.seconds[collector.seconds.size() / 2] / items * 1e9};
}

}  // namespace bench
