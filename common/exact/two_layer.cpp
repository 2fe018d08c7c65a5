#include "common/exact/two_layer.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* name = "two layers";

void require_scale(const char* what, double value) {
    require(value >= TwoLayer::least_scale && value <= TwoLayer::largest_scale, name, what, value,
            "1e-30..1e30");
}
void require_driver(const char* what, double value) {
    require(std::abs(value) <= TwoLayer::largest_scale, name, what, value, "-1e30..1e30");
}

/// From v(height) - v(0) = speed, the integral of tau/mu with tau = wall stress - force y.
double wall_stress(const TwoLayer::Problem& p) {
    const double below = p.interface * p.height, above = p.height - below;
    const double by_force =
        p.force / 2 * (below * below / p.lower_viscosity + above * (p.height + below) / p.upper_viscosity);
    return (p.speed + by_force) / (below / p.lower_viscosity + above / p.upper_viscosity);
}

}  // namespace

TwoLayer::TwoLayer(const Problem& problem) : problem_{problem} {
    require_scale("lower viscosity", problem.lower_viscosity);
    require_scale("upper viscosity", problem.upper_viscosity);
    require(problem.interface > 0 && problem.interface < 1, name, "interface", problem.interface,
            "0..1, both ends excluded");
    require_scale("height", problem.height);
    require_driver("speed", problem.speed);
    require_driver("force", problem.force);
    wall_stress_ = wall_stress(problem);
}

TwoLayer::State TwoLayer::at(double y) const {
    const Problem& p = problem_;
    require(y >= 0 && y <= p.height, name, "y", y, "0..height");
    const double tau = wall_stress_ - p.force * y;
    // Each layer from its own wall: the mean stress on the way times the way.
    if (y < p.interface * p.height) return {(wall_stress_ - p.force * y / 2) * y / p.lower_viscosity, tau};
    const double mean = wall_stress_ - p.force * (y + p.height) / 2;
    return {p.speed - mean * (p.height - y) / p.upper_viscosity, tau};
}

}  // namespace exact
