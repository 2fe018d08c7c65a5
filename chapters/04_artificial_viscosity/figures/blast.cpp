#include <algorithm>

#include "chapters/04_artificial_viscosity/figures/tubes.hpp"

namespace sph::shocks {
namespace {

/// The largest velocity over the largest exact one.
double fastest(const TubeRun& tube) {
    const auto largest = [](const Column& c) { return *std::max_element(c.begin(), c.end()); };
    return largest(tube.profile.v) / largest(tube.exact.v);
}

}  // namespace

void blast(report::Run& run) {
    const auto runs = tube_figure(run,
                                  {.name = "blast",
                                   .scene = {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006, 200},
                                   .drawn = {"signal", "reconstructed"},
                                   .low = 0.1,
                                   .high = 0.3,
                                   .block = "blast-series",
                                   .sizes = {200, 400},
                                   .compared = {"signal", "price", "narrow", "reconstructed"}},
                                  60);
    run.claim("blast-rings", [&] {
        const double beyond = fastest(run_of(runs, "reconstructed")) - 1;
        return beyond > 0.02 && beyond < 0.08;
    });
    run.claim("answer-blast", [&] {
        return run_of(runs, "reconstructed").l1_rho > run_of(runs, "alpha-beta").l1_rho &&
               run_of(runs, "price").l1_rho > run_of(runs, "alpha-beta").l1_rho;
    });
    run.claim("blast-narrow", [&] {
        return std::all_of(runs.begin(), runs.end(), [&](const auto& one) {
            return one.second.l1_rho >= run_of(runs, "narrow").l1_rho;
        });
    });
}

}  // namespace sph::shocks
