#include "chapters/03_euler_sph/scenes/listed.hpp"

namespace sph::euler {

void cost_of_effects(report::Run& run) {
    report::Prices prices{false};
    for (const auto& [label, pass] : listed_passes()) prices.add(run, label, pass);
    run.save(prices.figure("cost-of-effects", "2D, cubic spline, $h$ = 1.3 d$x$, one core"));
    run.fill("cost-of-effects", prices.table());
}

}  // namespace sph::euler
