#include "common/exact/sedov.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "point blast";

void require_scale(const char* what, double value) {
    require(value >= Sedov::least_scale && value <= Sedov::largest_scale, problem, what, value,
            "1e-60..1e60");
}

/// Of the unit sphere: two points, a circle, a sphere.
double surface(int dimension) {
    return dimension == 1 ? 2 : 2 * (dimension - 1) * std::numbers::pi;
}

}  // namespace

Sedov::Sedov(int dimension, double gamma, double energy, double density)
    : dimension_{dimension},
      gamma_{gamma},
      energy_{energy},
      density_{density},
      profile_{dimension, gamma},
      alpha_{8 * surface(dimension) / (std::pow(dimension + 2, 2) * (gamma - 1) * (gamma + 1)) *
             profile_.energy_integral()} {
    require_scale("energy", energy);
    require_scale("density", density);
}

double Sedov::shock_radius(double t) const {
    require_scale("time", t);
    const double power = 1.0 / (dimension_ + 2);
    return std::pow(energy_ / (alpha_ * density_), power) * std::pow(t, 2 * power);
}

double Sedov::shock_speed(double t) const {
    return 2 * shock_radius(t) / ((dimension_ + 2) * t);
}

Sedov::State Sedov::post_shock(double t) const {
    const double rho = (gamma_ + 1) / (gamma_ - 1) * density_;
    const double v = 2 / (gamma_ + 1) * shock_speed(t);
    const double u = v * v / 2;  // a strong shock heats the gas by as much as it moves it
    return {rho, v, (gamma_ - 1) * rho * u, u};
}

Sedov::State Sedov::at(double r, double t) const {
    require(r >= 0 && std::isfinite(r), problem, "r", r, "the finite numbers from 0 on");
    const double lambda = r / shock_radius(t);
    if (lambda > 1) return {density_, 0, 0, 0};
    const State shock = post_shock(t);
    const auto [rho, v, p, u] = profile_.at(lambda);
    return {shock.rho * rho, shock.v * v, shock.p * p, shock.u * u};
}

}  // namespace exact
