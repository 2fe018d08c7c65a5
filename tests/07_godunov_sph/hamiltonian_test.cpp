// Without a Riemann problem: what leapfrog keeps.
#include <catch2/catch.hpp>

#include "chapters/07_godunov_sph/scenes/hamiltonian.hpp"

using namespace sph::godunov;

TEST_CASE("the integral's energy is as good as the step squared, that of the pairs is not") {
    // Measured: ratios of 4.0, and 0.018 whatever the step. Fails for an enthalpy without P/rho (a ratio of
    // 1).
    const auto change = [](PairForce force, long steps) {
        return energy_change({.periods = 2, .steps = steps}, force);
    };
    const double coarse = change(PairForce::integral, 64), fine = change(PairForce::integral, 128);
    CHECK(coarse / fine == Approx(4).epsilon(0.05));
    CHECK(change(PairForce::cubic, 128) > 5 * fine);
}
