#include "common/exact/toy_star_modes.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "toy star";

void require_gamma(double gamma) {
    require(gamma > 1 && gamma <= 100, problem, "gamma", gamma, "(1, 100]");
}

void require_mode(int mode) {
    require(mode >= 1 && mode <= toy_star_largest_mode, problem, "mode", mode, "1..1000");
}

}  // namespace

double toy_star_frequency(double gamma, int mode) {
    require_gamma(gamma);
    require_mode(mode);
    const double j = mode - 1;
    return std::sqrt((gamma - 1) / 2 * j * (j - 1) + gamma * j + 1);
}

/// The recurrence of Gegenbauer polynomials (Abramowitz and Stegun, 22.7.3) for y_j = C_j(x) / C_j(1),
///     (j + 2 lambda - 1) y_j = 2 (j + lambda - 1) x y_(j-1) - (j - 1) y_(j-2),
/// as one for the rise y_j - y_(j-1), which keeps the digits that 1 - x has near the surface,
///     (j + 2 lambda - 1) (y_j - y_(j-1)) = (j - 1) (y_(j-1) - y_(j-2)) - 2 (j + lambda - 1) (1 - x) y_(j-1).
/// y_j stays within -1..1, where C_j itself would overflow. All is multiplied by gamma - 1, so that it also
/// holds for gamma -> 1, where y_j -> x^j.
double toy_star_velocity(double gamma, int mode, double x) {
    require_gamma(gamma);
    require_mode(mode);
    require(x >= -1 && x <= 1, problem, "x", x, "-1..1");
    const bool odd = mode % 2 == 0;
    if (x == 0 && odd) return 0;
    const double depth = 1 - std::fabs(x);
    const double lambda = (gamma + 1) / 2;  // times gamma - 1
    double value = 1;
    double rise = 0;
    for (int j = 1; j < mode; ++j) {
        const double order = (gamma - 1) * (j - 1);
        rise = (order * rise - 2 * (order + lambda) * depth * value) / (order + 2 * lambda);
        value += rise;
    }
    return x < 0 && odd ? -value : value;
}

double toy_star_density(double gamma, double K, double Omega, double x) {
    require_gamma(gamma);
    require(K > 0 && std::isfinite(K), problem, "K", K, "the positive numbers");
    require(Omega > 0 && std::isfinite(Omega), problem, "Omega", Omega, "the positive numbers");
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    if (std::fabs(x) >= 1) return 0;
    const double centre = (gamma - 1) * Omega * Omega / (2 * gamma * K);
    return std::pow(centre * (1 - x) * (1 + x), 1 / (gamma - 1));
}

}  // namespace exact
