#include "chapters/08_landau_model/figures/tubes.hpp"

namespace sph::landau {
void problem_1(report::Run& run) {
    TubeScene scene = problem(1);
    scene.n = 1000;
    tube_figure(run, {"problem-1", scene, -0.5, 0.5});
}
}  // namespace sph::landau
