#include "common/exact/toy_star_orbit.hpp"

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

namespace exact {
namespace {

using std::numbers::pi;

/// (e^x - 1) / x
double exprel(double x) {
    return x == 0 ? 1 : std::expm1(x) / x;
}

/// 2 (e^x - 1 - x) / x^2. (gsl_sf_exprel_2 has only ten digits at |x| = 0.002.)
double exprel_2(double x) {
    if (std::fabs(x) > 1) return 2 * (std::expm1(x) - x) / (x * x);
    double sum = 0;
    for (int k = 18; k >= 1; --k) sum = (sum + 1) * x / (k + 2);
    return 1 + sum;
}

/// s / y, from V = y^2 [exprel_2(2y) + (gamma-1)/2 exprel_2(-(gamma-1)y)], in which nothing cancels.
double steepness(double gamma, double y) {
    return std::sqrt(2 * exprel_2(2 * y) + (gamma - 1) * exprel_2(-(gamma - 1) * y));
}

/// V_q / y, where V_q = q - q^(-gamma).
double force(double gamma, double y) {
    return (gamma + 1) * std::exp(y) * exprel(-(gamma + 1) * y);
}

/// Bounds of |y| on the outer (s > 0) and the inner side, from V >= (e^(2y) - 1 - 2y)/2 >= y^2 for y > 0, and
/// for y = -z < 0 from V >= z - 1/2 and (gamma-1) V >= e^((gamma-1)z) - 1 - (gamma-1)z.
double outer_bound(double s) {
    return std::log1p(s * (s + std::numbers::sqrt2)) / 2;
}
double inner_bound(double gamma, double s) {
    const double linear = (s * s + 1) / 2;
    return std::min(linear, std::log1p((gamma - 1) * (s * s + 0.5)) / (gamma - 1));
}

/// The zero of an increasing function between low and high: Newton's method, or a bisection where a step
/// leaves the interval that is left. `step(x)` is the function over its derivative. The last step is a
/// Newton step below 1e-10 of x, which leaves 1e-20 of it times the relative curvature, 1000 at most.
double increasing_zero(double low, double high, double x, const auto& step) {
    constexpr int enough = 200;
    constexpr double small = 1e-10;
    for (int k = 0; k < enough; ++k) {
        const double change = step(x);
        (change > 0 ? high : low) = x;
        const double newton = x - change;
        const bool inside = newton >= low && newton <= high;
        if (inside && std::fabs(change) <= small * std::fabs(x)) return newton;
        x = inside ? newton : std::midpoint(low, high);
    }
    return x;
}

constexpr std::size_t nodes = 16;

struct Rule {
    std::array<double, nodes> place, weight;  // on 0..1
};

Rule gauss_legendre() {
    const std::unique_ptr<gsl_integration_glfixed_table, void (*)(gsl_integration_glfixed_table*)> table{
        gsl_integration_glfixed_table_alloc(nodes), gsl_integration_glfixed_table_free};
    Rule rule{};
    for (std::size_t k = 0; k < nodes; ++k)
        gsl_integration_glfixed_point(0, 1, k, &rule.place[k], &rule.weight[k], table.get());
    return rule;
}

}  // namespace

double ToyStarOrbit::swing(double gamma, double log_q, double speed) {
    return std::hypot(speed, log_q * steepness(gamma, log_q));
}

double ToyStarOrbit::farthest(double gamma, double swing) {
    return std::max(inner_bound(gamma, swing), outer_bound(swing));
}

/// q(s) has its nearest singularities where V_q = 0 again, at y = +-2 pi i / (gamma+1), or |s| about
/// sqrt(4 pi / (gamma+1)): the panels next to s = 0 are half as long at most, and each other one is as long
/// as its distance from s = 0. So the error of 16 nodes is below rounding.
ToyStarOrbit::ToyStarOrbit(double gamma, double log_q, double speed)
    : gamma_{gamma}, swing_{swing(gamma, log_q, speed)} {
    const double singular = std::sqrt(4 * pi / (gamma + 1));
    std::vector<double> outward{pi / 2};
    while (outward.back() * swing_ > singular / 2) outward.push_back(outward.back() / 2);
    for (const double edge : outward) edges_.push_back(-edge);
    edges_.push_back(0);
    edges_.insert(edges_.end(), outward.rbegin(), outward.rend());

    times_.push_back(0);
    for (std::size_t k = 1; k < edges_.size(); ++k)
        times_.push_back(times_.back() + time_between(edges_[k - 1], edges_[k]));

    const double phase = std::atan2(log_q * steepness(gamma, log_q), std::fabs(speed));
    start_ = std::copysign(time_from_inner_turn(phase), speed);
}

ToyStarOrbit::Point ToyStarOrbit::at(double time) const {
    const double signed_time = std::remainder(start_ + time, period());
    const double phase = phase_at(std::fabs(signed_time));
    return {log_q_at(phase), std::copysign(swing_ * std::cos(phase), signed_time)};
}

double ToyStarOrbit::log_q_at(double phase) const {
    const double s = swing_ * std::sin(phase);
    if (s == 0) return 0;
    const auto step = [&](double y) {
        const double rise = steepness(gamma_, y);
        return (y * rise - s) * rise / (force(gamma_, y) * std::exp(y));
    };
    if (s > 0) return increasing_zero(0, outer_bound(s), outer_bound(s), step);
    const double bound = inner_bound(gamma_, s);
    return increasing_zero(-bound, 0, -std::min(bound, -s), step);
}

double ToyStarOrbit::slowness(double phase) const {
    const double y = log_q_at(phase);
    return steepness(gamma_, y) / force(gamma_, y);
}

double ToyStarOrbit::time_between(double from, double to) const {
    static const Rule rule = gauss_legendre();
    double sum = 0;
    for (std::size_t k = 0; k < nodes; ++k)
        sum += rule.weight[k] * slowness(from + (to - from) * rule.place[k]);
    return sum * (to - from);
}

double ToyStarOrbit::time_from_inner_turn(double phase) const {
    const auto next = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, phase);
    const auto panel = static_cast<std::size_t>(next - edges_.begin()) - 1;
    return times_[panel] + time_between(edges_[panel], phase);
}

double ToyStarOrbit::phase_at(double time) const {
    const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    const auto panel = static_cast<std::size_t>(next - times_.begin()) - 1;
    const double from = edges_[panel];
    const double to = edges_[panel + 1];
    const double part = (time - times_[panel]) / (times_[panel + 1] - times_[panel]);
    return increasing_zero(from, to, std::lerp(from, to, std::clamp(part, 0.0, 1.0)), [&](double phase) {
        return (time_between(from, phase) - (time - times_[panel])) / slowness(phase);
    });
}

}  // namespace exact
