#include "chapters/02_consistency/figures/convergence_figure.hpp"

namespace sph::consistency {

report::Task convergence_2d() {
    return ConvergenceFigure<2>{"convergence-2d"};
}

}  // namespace sph::consistency
