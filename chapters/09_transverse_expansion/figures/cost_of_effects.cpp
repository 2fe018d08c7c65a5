#include "chapters/09_transverse_expansion/scenes/listed.hpp"

namespace sph::transverse {

void cost_of_effects(report::Run& run) {
    report::Prices prices{false};
    for (const auto& [label, pass] : listed_passes()) prices.add(run, label, pass);
    run.save(prices.figure("cost-of-effects", "2D, Wendland C4, $h$ = 1.8 d$x$, one core"));
    run.fill("cost-of-effects", prices.table());
}

}  // namespace sph::transverse
