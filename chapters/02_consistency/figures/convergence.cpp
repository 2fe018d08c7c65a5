#include "chapters/02_consistency/figures/convergence_figure.hpp"

namespace sph::consistency {

report::Task convergence() {
    return ConvergenceFigure<1>{"convergence"};
}

}  // namespace sph::consistency
