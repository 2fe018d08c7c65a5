#include "common/exact/gresho.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* vortex = "Gresho's vortex";

bool is_scale(double value) {
    return value >= Gresho::least_scale && value <= Gresho::largest_scale;
}

}  // namespace

Gresho::Gresho(double speed, double radius, double density, double pressure)
    : speed_{speed}, radius_{radius}, density_{density}, pressure_{pressure} {
    require(is_scale(speed), vortex, "speed", speed, "1e-50..1e50");
    require(is_scale(radius), vortex, "radius", radius, "1e-50..1e50");
    require(is_scale(density), vortex, "density", density, "1e-50..1e50");
    require(pressure >= 0 && pressure <= largest_scale, vortex, "pressure", pressure, "0..1e50");
}

Gresho::State Gresho::at(double r) const {
    require(r >= 0 && std::isfinite(r), vortex, "r", r, "the finite distances, 0 and above");
    const double s = r / radius_, unit = density_ * speed_ * speed_;
    if (s <= 1) return {speed_ * s, pressure_ + unit * s * s / 2};
    if (s < 2) return {speed_ * (2 - s), pressure_ + unit * (s * s / 2 + 4 - 4 * s + 4 * std::log(s))};
    return {0, pressure_ + unit * (4 * std::numbers::ln2 - 2)};
}

}  // namespace exact
