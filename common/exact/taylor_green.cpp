#include "common/exact/taylor_green.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::pi;
constexpr const char* problem = "Taylor-Green vortices";

void require_scale(const char* what, double value) {
    require(value >= TaylorGreen::least_scale && value <= TaylorGreen::largest_scale, problem, what, value,
            "1e-50..1e50");
}

}  // namespace

TaylorGreen::TaylorGreen(double viscosity, double speed, double side, double density)
    : viscosity_{viscosity}, speed_{speed}, side_{side}, density_{density} {
    require(viscosity >= 0 && viscosity <= largest_scale, problem, "viscosity", viscosity, "0..1e50");
    require_scale("speed", speed);
    require_scale("side", side);
    require_scale("density", density);
}

double TaylorGreen::decay_rate() const {
    const double k = 2 * pi / side_;
    return 2 * viscosity_ * k * k;
}

/// exp(-bt), the factor of the velocity.
double TaylorGreen::decay(double t) const {
    require(t >= 0 && t <= largest_scale, problem, "time", t, "0..1e50");
    return std::exp(-decay_rate() * t);
}

double TaylorGreen::kinetic_energy(double t) const {
    const double v = speed_ * decay(t);
    return v * v / 4;
}

TaylorGreen::State TaylorGreen::at(double x, double y, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    require(std::isfinite(y), problem, "y", y, "the finite numbers");
    const double kx = 2 * pi * (std::remainder(x, side_) / side_);
    const double ky = 2 * pi * (std::remainder(y, side_) / side_);
    const double v = speed_ * decay(t);
    return {-v * std::cos(kx) * std::sin(ky), v * std::sin(kx) * std::cos(ky),
            -density_ * v * v / 4 * (std::cos(2 * kx) + std::cos(2 * ky))};
}

}  // namespace exact
