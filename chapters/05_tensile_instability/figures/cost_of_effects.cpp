#include "chapters/05_tensile_instability/scenes/listed.hpp"

namespace sph::tensile {

void cost_of_effects(report::Run& run) {
    report::Prices prices{true};
    for (const auto& [label, pass] : listed_passes()) prices.add(run, label, pass);
    run.save(prices.figure("cost-of-effects", "2D, cubic spline, $h$ = 1.2 d$x$, one core"));
    run.fill("cost-of-effects", prices.table());
}

}  // namespace sph::tensile
