#include "common/exact/rarefaction.hpp"

#include <algorithm>
#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "rarefaction into vacuum";

void require_scale(const char* what, double value) {
    require(value >= Rarefaction::least_scale && value <= Rarefaction::largest_scale, problem, what, value,
            "1e-100..1e100");
}

}  // namespace

Rarefaction::Rarefaction(double rho0, double u0, double gamma, double half_width)
    : rho0_{rho0}, u0_{u0}, gamma_{gamma}, half_width_{half_width}, c0_{std::sqrt(gamma * (gamma - 1) * u0)} {
    require_scale("rho", rho0);
    require_scale("u", u0);
    require(gamma > 1 && gamma <= largest_gamma, problem, "gamma", gamma, "(1, 100]");
    require_scale("half width", half_width);
}

void Rarefaction::require_time(double t) const {
    require(t >= 0 && t <= meeting_time(), problem, "time", t,
            "0..a/c0, from when on the two rarefactions overlap");
}

double Rarefaction::front(double t) const {
    require_time(t);
    return half_width_ + 2 * c0_ * t / (gamma_ - 1);
}

double Rarefaction::head(double t) const {
    require_time(t);
    return std::max(0.0, half_width_ - c0_ * t);
}

Rarefaction::State Rarefaction::at_rest() const {
    return {rho0_, 0, (gamma_ - 1) * rho0_ * u0_, u0_};
}

Rarefaction::State Rarefaction::at(double x, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    const double place = std::fabs(x);
    const double from = head(t);
    const double to = front(t);
    if (place <= from) return at_rest();
    if (place >= to) return {0, 0, 0, 0};
    const double part = (place - from) / (to - from);
    const double log_c = std::log1p(-part);  // ln(c/c0), with the digits that gamma -> 1 asks for
    const double v = 2 * c0_ / (gamma_ - 1) * part;
    const double rho = rho0_ * std::exp(2 / (gamma_ - 1) * log_c);
    const double u = u0_ * std::exp(2 * log_c);
    return {rho, std::copysign(v, x), (gamma_ - 1) * rho * u, u};
}

/// With the difference from the head, a - c0 t, so that gamma -> 1 cancels nothing.
double Rarefaction::trajectory(double x0, double t) const {
    require(std::fabs(x0) <= half_width_, problem, "x0", x0, "-a..a");
    require_time(t);
    const double reached = (half_width_ - std::fabs(x0)) / c0_;
    if (t <= reached) return x0;
    const double exponent = (gamma_ - 1) / (gamma_ + 1);
    const double behind_head = -c0_ * t / exponent * std::expm1(exponent * std::log(reached / t));
    return std::copysign(head(t) + behind_head, x0);
}

}  // namespace exact
