#include "chapters/07_godunov_sph/scenes/listed.hpp"

namespace sph::godunov {

void cost_of_effects(report::Run& run) {
    report::Prices prices{true};
    for (const auto& [label, pass] : listed_passes()) prices.add(run, label, pass);
    run.save(prices.figure("cost-of-effects", "2D, Gaussian cut at 3√2 $h$, $h$ = d$x$, one core"));
    run.fill("cost-of-effects", prices.table());
}

}  // namespace sph::godunov
