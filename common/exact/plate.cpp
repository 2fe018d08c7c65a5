#include "common/exact/plate.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::pi;
constexpr const char* problem = "plate";

void require_scale(const char* what, double value) {
    require(value >= ClampedPlate::least_scale && value <= ClampedPlate::largest_scale, problem, what, value,
            "1e-50..1e50");
}
void require_mode(int mode, int largest, const char* range) {
    require(mode >= 1 && mode <= largest, problem, "mode", mode, range);
}

}  // namespace

double bending_stiffness(double thickness, double young, double poisson, Plane plane) {
    require_scale("thickness", thickness);
    require_scale("young", young);
    require(poisson > -1 && poisson <= 0.5, problem, "poisson", poisson, "(-1, 0.5]");
    const double modulus = plane == Plane::strain ? young / (1 - poisson * poisson) : young;
    return modulus * thickness * thickness * thickness / 12;
}

ClampedPlate::ClampedPlate(double thickness, double length, double young, double poisson, double density,
                           Plane plane)
    : length_{length} {
    require_scale("length", length);
    require_scale("density", density);
    const double stiffness = bending_stiffness(thickness, young, poisson, plane);
    frequency_ = std::sqrt(stiffness / (density * thickness)) / length / length;
}

/// The root of cos k + 1/cosh k lies within 0.31 of (n - 1/2) pi, and Newton's steps from there converge.
double ClampedPlate::wave_number(int mode) {
    require_mode(mode, largest_mode, "1..1000");
    double k = (mode - 0.5) * pi;
    for (int step = 0; step < 20; ++step) {
        const double sech = 1 / std::cosh(k);
        k -= (std::cos(k) + sech) / (-std::sin(k) - sech * std::tanh(k));
    }
    return k;
}

double ClampedPlate::omega(int mode) const {
    const double k = wave_number(mode);
    return k * k * frequency_;
}

double ClampedPlate::shape(int mode, double x) const {
    require_mode(mode, largest_shape, "1..5");
    require(x >= 0 && x <= length_, problem, "x", x, "0..length");
    const double k = wave_number(mode), at = k * (x / length_);
    const double s = (std::sinh(k) - std::sin(k)) / (std::cosh(k) + std::cos(k));
    return std::cosh(at) - std::cos(at) - s * (std::sinh(at) - std::sin(at));
}

LoadedBeam::LoadedBeam(double thickness, double length, double young, double poisson, double load,
                       Plane plane)
    : length_{length}, load_{load}, stiffness_{bending_stiffness(thickness, young, poisson, plane)} {
    require_scale("length", length);
    require(std::abs(load) <= ClampedPlate::largest_scale, problem, "load", load, "-1e50..1e50");
}

double LoadedBeam::deflection(double x) const {
    require(x >= 0 && x <= length_, problem, "x", x, "0..length");
    return load_ / stiffness_ * x * x * (3 * length_ - x) / 6;
}

}  // namespace exact
