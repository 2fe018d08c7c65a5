#include "chapters/08_landau_model/figures/tubes.hpp"

namespace sph::landau {
void problem_2(report::Run& run) {
    TubeScene scene = problem(2);
    scene.n = 1000;
    tube_figure(run, {"problem-2", scene, 0.3, 0.37, true});
}
}  // namespace sph::landau
