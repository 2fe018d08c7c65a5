#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "common/exact/burgers.hpp"
#include "tests/common/exact/derivatives.hpp"

using exact::Burgers;

namespace {

/// |u_t + u u_x - nu u_xx| over the sum of the three terms' magnitudes.
double relative_residual(const Burgers& solution, double x, double t) {
    const double nu = solution.viscosity();
    const double u = solution.velocity(x, t);
    // Fractions of the lengths and times in which u varies: of the wave and of the shock's layer, 2 nu wide.
    const double length = std::min(0.02, 0.1 * nu);
    const double time = std::min({t / 20, 0.2 * nu, 0.004 / nu});
    const auto in_x =
        finite_difference::derivatives(length, [&](double s) { return solution.velocity(x + s, t); });
    const auto in_t =
        finite_difference::derivatives(time, [&](double s) { return solution.velocity(x, t + s); });
    const double advection = u * in_x.first;
    const double diffusion = nu * in_x.second;
    return std::fabs(in_t.first + advection - diffusion) /
           (std::fabs(in_t.first) + std::fabs(advection) + std::fabs(diffusion));
}

}  // namespace

// With the initial values (t = 0 in burgers_values_test.cpp) this decides the solution, without any table.
// Measured: 5.7e-10, the truncation of the differences in the shock. Broken by any wrong factor or sign in
// either method: 4 nu t -> nu t, 2 pi nu -> pi nu, a series without its factors n, half the range.
TEST_CASE("Burgers: the values obey the equation") {
    for (const double nu : {1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0, 3.0, 10.0}) {
        const Burgers solution{nu};
        for (const double t : {0.01, 0.1, 0.3, 0.5, 1.0, 2.0, 4.9}) {
            for (const double x : {0.03, 0.25, 0.5, 0.75, 0.9, 0.97, 1 - 2 * nu, 1 - nu / 2}) {
                if (x <= 0) continue;
                CAPTURE(nu, t, x);
                CHECK(relative_residual(solution, x, t) < 2e-9);
            }
        }
    }
}
