#include "chapters/02_consistency/scenes/edge_line.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/splines.hpp"

namespace sph::consistency {

EdgeLine::EdgeLine(const ParticleSet& set) : x_{set.points<1>()[0]}, h_{set.h()} {}

double EdgeLine::constant(double place) const {
    double sum = 0;
    for (const double x : x_) sum += QuinticSpline<1>::W(std::abs(place - x), h_);
    return sum / static_cast<double>(x_.size());
}

}  // namespace sph::consistency
