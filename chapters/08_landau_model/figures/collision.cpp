#include "chapters/08_landau_model/figures/tubes.hpp"

namespace sph::landau {
void collision(report::Run& run) {
    TubeScene scene = streams();
    scene.n = 400;
    tube_figure(run, {"collision", scene, -0.3, 0.3});
}
}  // namespace sph::landau
