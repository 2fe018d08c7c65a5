#include "common/exact/shear_wave.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::pi;
constexpr const char* problem = "shear wave";

void require_scale(const char* what, double value) {
    require(value >= ShearWave::least_scale && value <= ShearWave::largest_scale, problem, what, value,
            "1e-50..1e50");
}

}  // namespace

ShearWave::ShearWave(double viscosity, double speed, double side, int mode)
    : viscosity_{viscosity}, speed_{speed}, side_{side}, mode_{mode} {
    require(viscosity >= 0 && viscosity <= largest_scale, problem, "viscosity", viscosity, "0..1e50");
    require_scale("speed", speed);
    require_scale("side", side);
    require(mode >= 1 && mode <= largest_mode, problem, "mode", mode, "1..1000");
}

double ShearWave::decay_rate() const {
    const double k = 2 * pi * mode_ / side_;
    return viscosity_ * k * k;
}

double ShearWave::velocity(double x, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    require(t >= 0 && t <= largest_scale, problem, "time", t, "0..1e50");
    const double phase = 2 * pi * mode_ * (std::remainder(x, side_) / side_);
    return speed_ * std::sin(phase) * std::exp(-decay_rate() * t);
}

}  // namespace exact
