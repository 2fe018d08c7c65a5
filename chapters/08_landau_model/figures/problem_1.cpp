#include "chapters/08_landau_model/figures/tubes.hpp"

namespace sph::landau {
void problem_1(report::Run& run) {
    using shocks::Profile;
    TubeScene scene = problem(1);
    scene.n = 1000;
    const TubeEntries all = tube_figure(run, {"problem-1",
                                              scene,
                                              {{"", "ρ", &Profile::rho, -0.5, 0.5},
                                               {"head of the fan", "ρ", &Profile::rho, -0.33, -0.23},
                                               {"contact and shock", "ρ", &Profile::rho, 0.26, 0.35},
                                               {"contact and shock", "$v$", &Profile::v, 0.26, 0.35}}});
    const TubeRun &classical = entry_of(all, "chow-monaghan").run, &best = entry_of(all, "reconstructed").run,
                  &grid = entry_of(all, "grid").run;
    const auto below = [](const TubeRun& a, const TubeRun& b, double share) {
        return a.l1_rho < share * b.l1_rho && a.l1_v < share * b.l1_v && a.l1_p < share * b.l1_p;
    };
    run.fill("p1-head", report::percent(best.overshoot));
    run.claim("p1-better", [&] { return below(best, classical, 0.5); });
    run.claim("p1-grid", [&] {
        return below(grid, best, 0.6) && entry_of(all, "grid").run.seconds < best.seconds / 20;
    });
    run.claim("p1-head", [&] { return best.overshoot > 0.005; });
    run.claim(
        "tubes-conserve",
        [&] {
            for (const TubeEntry& one : all) {
                if (!(one.run.energy_drift < 1e-13 && one.run.momentum_drift < 1e-13)) return false;
            }
            return true;
        },
        report::Needs::any_run);
}
}  // namespace sph::landau
