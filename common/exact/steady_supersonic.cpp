#include "common/exact/steady_supersonic.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

/// Where a rising function passes 0, between low and high, to rounding.
template <class Function>
double root_of(const Function& rising, double low, double high) {
    for (double middle = low + (high - low) / 2; middle > low && middle < high;
         middle = low + (high - low) / 2)
        (rising(middle) < 0 ? low : high) = middle;
    return low;
}
/// By how much a shock at the angle beta turns the flow.
double turned(double mach, double beta, double gamma) {
    const double s = std::sin(beta), c = std::cos(beta), m2 = mach * mach;
    return std::atan2(2 * c * (m2 * s * s - 1), s * (m2 * (gamma + c * c - s * s) + 2));
}
/// The shock angle of the largest turn.
double steepest_turn(double mach, double gamma) {
    const double m2 = mach * mach, g = gamma + 1;
    const double root = std::sqrt(g * (1 + (gamma - 1) / 2 * m2 + g / 16 * m2 * m2));
    return std::asin(std::sqrt((g / 4 * m2 - 1 + root) / (gamma * m2)));
}
void require_flow(const char* problem, double mach, bool supersonic, double gamma) {
    require(supersonic && mach <= TurnedFlow::largest_mach, problem, "mach", mach, "above 1, up to 1e6");
    require(gamma > 1 && gamma <= TurnedFlow::largest_gamma, problem, "gamma", gamma, "(1, 100]");
}
constexpr const char* shock = "oblique shock";
constexpr const char* fan = "Prandtl-Meyer fan";

}  // namespace

double ObliqueShock::largest_angle(double mach, double gamma) {
    require_flow(shock, mach, mach > 1, gamma);
    return turned(mach, steepest_turn(mach, gamma), gamma);
}

ObliqueShock::ObliqueShock(double mach, double angle, double gamma, Branch branch)
    : mach_{mach}, angle_{angle}, gamma_{gamma} {
    const double largest = largest_angle(mach, gamma);
    const std::string range = "0.." + std::to_string(largest) + ", the largest of an attached shock";
    require(angle >= 0 && angle <= largest, shock, "angle", angle, range.c_str());
    const double steepest = steepest_turn(mach, gamma);
    const auto beyond = [&](double beta) { return turned(mach, beta, gamma) - angle; };
    beta_ = branch == Branch::weak
                ? root_of(beyond, std::asin(1 / mach), steepest)
                : root_of([&](double beta) { return -beyond(beta); }, steepest, right_angle);
    const double normal = mach * std::sin(beta_);
    normal2_ = std::fmax(1, normal * normal);
}

double ObliqueShock::mach_behind() const {
    const double behind2 = (1 + (gamma_ - 1) / 2 * normal2_) / (gamma_ * normal2_ - (gamma_ - 1) / 2);
    return std::sqrt(behind2) / std::sin(beta_ - angle_);
}
double ObliqueShock::p_ratio() const {
    return 1 + 2 * gamma_ / (gamma_ + 1) * (normal2_ - 1);
}
double ObliqueShock::rho_ratio() const {
    return (gamma_ + 1) * normal2_ / ((gamma_ - 1) * normal2_ + 2);
}

double PrandtlMeyer::nu(double mach, double gamma) {
    require_flow(fan, mach, mach >= 1, gamma);
    const double k = std::sqrt((gamma + 1) / (gamma - 1)), root = std::sqrt((mach - 1) * (mach + 1));
    return k * std::atan(root / k) - std::atan(root);
}
double PrandtlMeyer::largest_angle(double mach, double gamma) {
    return right_angle * (std::sqrt((gamma + 1) / (gamma - 1)) - 1) - nu(mach, gamma);
}

PrandtlMeyer::PrandtlMeyer(double mach, double angle, double gamma) : mach_{mach}, gamma_{gamma} {
    const double largest = largest_angle(mach, gamma), wanted = nu(mach, gamma) + angle;
    const std::string range = "0 to below " + std::to_string(largest) + ", which leads into the vacuum";
    require(angle >= 0 && angle < largest, fan, "angle", angle, range.c_str());
    const double k = std::sqrt((gamma + 1) / (gamma - 1));
    // In wave = arctan(root): it is bounded.
    const auto beyond = [&](double wave) { return k * std::atan(std::tan(wave) / k) - wave - wanted; };
    const double wave = root_of(beyond, std::acos(1 / mach), right_angle);
    mach_behind_ = angle > 0 ? 1 / std::cos(wave) : mach;
}
double PrandtlMeyer::mach_on_ray(double ray) const {
    const auto behind = [&](double mach) {
        return ray - std::asin(1 / mach) + nu(mach, gamma_) - nu(mach_, gamma_);
    };
    if (behind(mach_) >= 0) return mach_;
    if (behind(mach_behind_) <= 0) return mach_behind_;
    return root_of(behind, mach_, mach_behind_);
}
double PrandtlMeyer::p_ratio() const {
    return std::pow(rho_ratio(), gamma_);
}
double PrandtlMeyer::rho_ratio() const {
    const auto heat = [&](double mach) { return 1 + (gamma_ - 1) / 2 * mach * mach; };
    return std::pow(heat(mach_) / heat(mach_behind_), 1 / (gamma_ - 1));
}

}  // namespace exact
