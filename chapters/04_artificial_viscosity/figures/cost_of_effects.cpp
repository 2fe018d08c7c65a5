#include "chapters/04_artificial_viscosity/scenes/listed.hpp"

namespace sph::shocks {

void cost_of_effects(report::Run& run) {
    report::Prices prices{true};
    for (const auto& [label, pass] : listed_passes()) prices.add(run, label, pass);
    run.save(prices.figure("cost-of-effects", "2D, cubic spline, own $h$ = 1.2 d$x$, one core"));
    run.fill("cost-of-effects", prices.table());
}

}  // namespace sph::shocks
