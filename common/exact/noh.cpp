#include "common/exact/noh.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "Noh problem";

void require_scale(const char* what, double value) {
    require(value >= Noh::least_scale && value <= Noh::largest_scale, problem, what, value, "1e-50..1e50");
}

}  // namespace

Noh::Noh(int dimension, double gamma, double density, double speed)
    : dimension_{dimension}, gamma_{gamma}, density_{density}, speed_{speed} {
    require(dimension >= 1 && dimension <= 3, problem, "dimension", dimension, "1..3");
    require(gamma > 1 && gamma <= largest_gamma, problem, "gamma", gamma, "(1, 100]");
    require_scale("density", density);
    require_scale("speed", speed);
}

double Noh::shock_position(double t) const {
    require(t >= 0 && t <= largest_scale, problem, "time", t, "0..1e50");
    return shock_speed() * t;
}

Noh::State Noh::post_shock() const {
    const double rho = density_ * std::pow((gamma_ + 1) / (gamma_ - 1), dimension_);
    const double u = speed_ * speed_ / 2;
    return {rho, 0, (gamma_ - 1) * rho * u, u};
}

Noh::State Noh::at(double x, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    require(x >= 0 || dimension_ == 1, problem, "x", x, "0 and above, as dimensions 2 and 3 have it");
    const double distance = std::fabs(x);
    if (distance <= shock_position(t)) return post_shock();
    const double rho = density_ * std::pow(1 + speed_ * t / distance, dimension_ - 1);
    return {rho, -std::copysign(speed_, x), 0, 0};
}

}  // namespace exact
