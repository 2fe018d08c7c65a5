#include "chapters/09_transverse_expansion/scenes/rings_grid.hpp"

#include <cmath>

#include "common/app/clock.hpp"
#include "common/exact/transverse_finite_volume.hpp"

namespace sph::transverse {

RingsRun run_rings(const Flow& flow, std::size_t n, double tau) {
    // Rings that reach a twentieth beyond the cylinder at the start, and the vacuum's edge at the end.
    const double end = 1.05 * flow.radius,
                 expansion = ((flow.radius + tau - flow.tau0) / end - 1) / (tau - flow.tau0);
    exact::TransverseFiniteVolume grid{exact::disc(flow.radius, end, n),
                                       exact::BaryonFreeFluid{flow.c2},
                                       {.tau0 = flow.tau0, .expansion = expansion}};
    RingsRun run;
    run.seconds = app::thread_cpu_seconds([&] { grid.advance_to(tau); });
    run.steps = grid.steps();
    const FlowProfile exact = flow.exact(tau);
    const auto cells = grid.cells();
    double difference = 0, whole = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double T = std::pow(cells.states[i].eps, flow.c2 / (1 + flow.c2)), r = cells.centre(i);
        run.r.push_back(r), run.temperature.push_back(T);
        if (r >= flow.window) continue;
        difference += r * std::abs(T - exact(r).temperature), whole += r * exact(r).temperature;
    }
    run.l1_temperature = difference / whole;
    return run;
}

}  // namespace sph::transverse
