#include "chapters/08_landau_model/figures/tubes.hpp"
#include "common/report/comparison.hpp"

namespace sph::landau {
void collision(report::Run& run) {
    TubeScene scene = streams();
    scene.n = 400;
    const auto errors = tube_figure(run, {"collision", scene, -0.3, 0.3});
    run.claim(
        "streams",
        [&] {
            const auto ratio = [&](const char* quantity) {
                return report::value_of(errors.at("reconstructed"), quantity) /
                       report::value_of(errors.at("chow-monaghan"), quantity);
            };
            return ratio("l1_rho") < 1 && ratio("l1_v") < 1 && ratio("l1_p") < 1 &&
                   ratio("shock_error") > 1.2;
        },
        report::Needs::any_run);
}
}  // namespace sph::landau
