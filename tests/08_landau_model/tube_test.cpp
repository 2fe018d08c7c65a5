// Relativistic tubes against the exact solution.
#include <catch2/catch.hpp>
#include <cmath>

#include "chapters/08_landau_model/scenes/grid.hpp"
#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"
#include "common/core/unstable.hpp"
#include "common/report/norms.hpp"

using namespace sph;
using namespace sph::landau;

namespace {

TubeScene scene(const exact::Riemann::State& left, const exact::Riemann::State& right, double gamma,
                double time, std::size_t n, double jitter = 0) {
    TubeScene scene{left, right, gamma, time};
    scene.n = n, scene.jitter = jitter;
    return scene;
}
TubeRun run(const TubeScene& scene) {
    return run_relativistic_tube(scene, relativistic_methods().recommended());
}
const exact::Riemann::State hot{10, 0, 13.33}, cold{1, 0, 1e-8};

}  // namespace

TEST_CASE("a boosted uniform gas stays uniform at lorentz 100") {
    const double v = std::sqrt(1 - 1e-4);
    for (const double jitter : {0.0, 0.1}) {
        const auto result = run(scene({1, v, 1}, {1, v, 1}, 4.0 / 3, 0.2, 200, jitter));
        // Measured 1e-12 on even particles; disordered ones keep the noise of their density, 5 %.
        CHECK(result.l1_rho < (jitter > 0 ? 0.06 : 1e-10));
        CHECK(result.l1_v < 1e-4);
        CHECK(result.energy_drift < 1e-13);
    }
}

TEST_CASE("the first blast") {
    const auto coarse = run(scene(hot, cold, 5.0 / 3, 0.4, 200));
    const auto fine = run(scene(hot, cold, 5.0 / 3, 0.4, 400));
    CHECK(fine.l1_rho < 0.012);  // measured 0.0104; N = 1000: 0.0049
    CHECK(shock_of(fine, scene(hot, cold, 5.0 / 3, 0.4, 400)).value().error < 0.01);
    CHECK(fine.energy_drift < 1e-13);
    CHECK(fine.momentum_drift < 1e-13);
    CHECK(report::observed_order(200, coarse.l1_rho, 400, fine.l1_rho) > 0.6);
    const auto shaken = run(scene(hot, cold, 5.0 / 3, 0.4, 400, 0.1));
    CHECK(shaken.l1_rho < 0.025);
    // Without dissipation the same blast leaves physics.
    CHECK_THROWS_AS(
        run_relativistic_tube(scene(hot, cold, 5.0 / 3, 0.4, 100), relativistic_methods()["none"]), Unstable);
}

TEST_CASE("the thin shell of the second blast") {
    TubeScene blast = problem(2);
    blast.n = 200;
    const auto result = run(blast);
    const Shock shock = shock_of(result, blast).value();
    CHECK(result.l1_v < 0.06);
    CHECK(shock.error < 0.03);
    CHECK(shock.peak > 0.7);
    CHECK(shock.peak < 1.15);
}

TEST_CASE("streams of lorentz 20 collide") {
    const double v = std::sqrt(1 - 1 / 400.0);
    const auto result = run(scene({1, v, 1e-3}, {1, -v, 1e-3}, 4.0 / 3, 0.3, 300));
    CHECK(result.l1_rho < 0.04);
    CHECK(result.l1_p < 0.03);
    CHECK(result.energy_drift < 1e-12);
}

TEST_CASE("slow and cold gas is chapter 4's") {
    // c_s/c = 1e-3: Sod's tube with times longer by as much.
    const double s = 1e-6;
    const auto slow = run(scene({1, 0, s}, {0.125, 0, 0.1 * s}, 1.4, 0.2 / std::sqrt(s), 200));
    TubeScene sod;
    sod.n = 200;
    const TubeRun newton = shocks::run_tube(sod, shocks::tube_methods().recommended());
    CHECK(slow.l1_rho == Approx(newton.l1_rho).epsilon(0.5));
    CHECK(slow.l1_rho < 0.02);
}

TEST_CASE("the grid runs the same tubes") {
    CHECK(run_grid_relativistic_tube(scene(hot, cold, 5.0 / 3, 0.4, 400)).l1_rho < 0.03);
}

TEST_CASE("scenes that are none are refused") {
    const auto refused = [](const TubeScene& scene) { CHECK_THROWS_AS(run(scene), std::invalid_argument); };
    refused(scene({1, 1, 1}, cold, 1.4, 0.1, 50));
    refused(scene(hot, {1, 0, 1e-14}, 1.4, 0.1, 50));
    refused(scene(hot, cold, 2.5, 0.1, 50));
    refused(scene(hot, cold, 1.4, 0, 50));
    refused(scene(hot, cold, 1.4, 0.1, 50, 0.5));
}

TEST_CASE("a shock to the left is found as its mirror image is") {
    // Fails if only the right wave is looked at.
    const TubeScene one = scene(hot, cold, 5.0 / 3, 0.4, 200);
    const TubeScene other = scene(cold, hot, 5.0 / 3, 0.4, 200);
    const auto right = shock_of(run(one), one), left = shock_of(run(other), other);
    REQUIRE((left && right));
    CHECK(left->place == Approx(-right->place).epsilon(1e-6));
    CHECK(left->error < 0.03);
    const TubeScene apart = scene({1, -0.5, 1}, {1, 0.5, 1}, 5.0 / 3, 0.3, 100);
    CHECK_FALSE(shock_of(run(apart), apart));
}

TEST_CASE("hot beside hot, and cold gas ahead of a blast, take as many steps as any other") {
    // Fails without the limit by what light particles bear: 180000 steps; and with 20 halvings: none.
    TubeScene both = scene({1, 0, 1e6}, {1, 0, 1e3}, 5.0 / 3, 0.35, 50);
    both.most_steps = 1000;
    const TubeRun result = run(both);
    CHECK(result.counters.steps < 500);                  // measured 237
    CHECK(shock_of(result, both).value().error < 0.12);  // measured 0.094 with 50 particles
    TubeScene ahead = scene({1, 0, 1000}, {1, 0, 1e-9}, 5.0 / 3, 0.35, 100);
    ahead.most_steps = 3000;
    CHECK(run(ahead).l1_p < 0.04);  // measured 0.030
}
