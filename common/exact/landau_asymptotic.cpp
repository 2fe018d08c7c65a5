#include "common/exact/landau_asymptotic.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr double c2 = 1.0 / 3;

}  // namespace

double LandauAsymptotics::delta() {
    return std::sqrt((1 - c2) / std::numbers::pi);
}

bool LandauAsymptotics::holds(double x) const {
    return std::fabs(x) <= t - delta();
}

LandauAsymptotics::State LandauAsymptotics::at(double x) const {
    constexpr const char* problem = "Landau slab, asymptotic";
    require(t > 0 && std::isfinite(t), problem, "time", t, "the finite numbers above 0");
    require(holds(x), problem, "x", x, "|x| <= t - Delta");
    const double ahead = std::log((t + x) / delta()), behind = std::log((t - x) / delta());
    const double sum = ahead + behind;  // L; M is their difference, and L^2 - M^2 = 4 ahead behind
    const double root = 2 * std::sqrt(std::fmax(ahead * behind, 0));
    return {(ahead - behind) / 2, -(1 + c2) / 4 * sum + (1 - c2) / 4 * root, -c2 / 2 * sum};
}

}  // namespace exact
