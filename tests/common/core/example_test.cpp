#include "tests/common/core/example.hpp"

#include <catch2/catch.hpp>

namespace {

example::Drop lattice(std::size_t side) {
    example::Drop drop{side * side};
    const double dx = 1.0 / static_cast<double>(side);
    for (std::size_t i = 0; i < drop.size(); ++i) {
        const std::size_t row = i / side;
        drop.x[0][i] = (static_cast<double>(i % side) + 0.5) * dx - 0.5;
        drop.x[1][i] = (static_cast<double>(row) + 0.5) * dx - 0.5;
        drop.m[i] = dx * dx;
    }
    return drop;
}

double momentum(const example::Drop& drop, std::size_t axis) {
    double sum = 0;
    for (std::size_t i = 0; i < drop.size(); ++i) sum += drop.m[i] * drop.v[axis][i];
    return sum;
}
/// Kinetic, internal (u = rho for p = rho^2) and of the spring.
double energy(const example::Drop& drop) {
    double sum = 0;
    for (std::size_t i = 0; i < drop.size(); ++i) {
        for (std::size_t a = 0; a < 2; ++a)
            sum += 0.5 * drop.m[i] * (drop.v[a][i] * drop.v[a][i] + drop.x[a][i] * drop.x[a][i]);
        sum += drop.m[i] * drop.rho[i];
    }
    return sum;
}

}  // namespace

TEST_CASE("the README's scene conserves momentum and energy, on one thread as on two") {
    // A drop that starts square and oscillates. Forces that do not cancel, or a density that is not the one
    // they come from, would show here.
    auto one = lattice(16), two = lattice(16), start = lattice(16);
    const double h = 1.3 / 16;
    example::run(start, h, 1e-9, 1, 1);
    const sph::Counters counters = example::run(one, h, 2, 500, 1);
    example::run(two, h, 2, 500, 2);
    CHECK(one.x == two.x);
    CHECK(one.v == two.v);
    CHECK(std::abs(momentum(one, 0)) < 1e-14);                  // measured 1e-17
    CHECK(energy(one) == Approx(energy(start)).epsilon(2e-4));  // measured 2e-5: leapfrog
    CHECK(counters.steps == 500);
    CHECK(counters.searches == 501);
    CHECK(counters.passes == 1002);
}
