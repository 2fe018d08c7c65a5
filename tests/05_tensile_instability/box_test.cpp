// The box of liquid that the chapter's scenes share.
#include <catch2/catch.hpp>

#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"

namespace {

using namespace sph;
using namespace sph::tensile;

double largest(const Columns<2>& columns) {
    double most = 0;
    for (const Column& column : columns)
        for (const double value : column) most = std::max(most, std::abs(value));
    return most;
}

}  // namespace

TEST_CASE("on the lattice the pressure is the scene's, and no force acts") {
    for (const double pressure : {-0.5, 0.5}) {
        const auto liquid = liquid_box({.per_side = 12, .h_over_dx = 1.5, .pressure = pressure});
        liquid->rates(0);
        for (const double p : liquid->particles.p) CHECK(std::abs(p - pressure) < 1e-13);  // 2e-15
        CHECK(largest(liquid->particles.dv_dt) < 1e-13);                                   // 1e-15
    }
}

TEST_CASE("a liquid keeps momentum and energy, and does so for one thread and for two") {
    LatticeBox box{.per_side = 12, .pressure = 0.2, .jitter = 0.1, .courant = 0.02};
    const auto run = [&](int threads) {
        box.threads = threads;
        auto liquid = liquid_box(box);
        liquid->resolve(0);
        Drifts drifts{*liquid};
        double t = 0;
        march(*liquid, t, {.end = 4});
        liquid->resolve(t);
        drifts.look();
        CHECK(drifts.momentum() < 1e-13);  // 3e-15
        CHECK(drifts.energy() < 2e-4);     // a flipped sign of the force makes it 1
        return liquid->particles.x;
    };
    CHECK(run(1) == run(2));
}
