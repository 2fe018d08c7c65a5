// Scenes that move: reversal, stars, rarefaction, necklace, liquid.
#include <catch2/catch.hpp>

#include "chapters/03_euler_sph/scenes/disc.hpp"
#include "chapters/03_euler_sph/scenes/lagrangian_grid.hpp"
#include "chapters/03_euler_sph/scenes/necklace.hpp"
#include "chapters/03_euler_sph/scenes/orbit.hpp"
#include "chapters/03_euler_sph/scenes/patch.hpp"
#include "chapters/03_euler_sph/scenes/rarefaction.hpp"
#include "chapters/03_euler_sph/scenes/reversal.hpp"
#include "chapters/03_euler_sph/scenes/star_energy.hpp"
#include "common/exact/toy_star.hpp"
#include "common/exact/toy_star_modes.hpp"

using namespace sph;
using namespace sph::euler;

TEST_CASE("leapfrog and reversible steps return to where they began") {
    for (const std::string name : {"kick-drift-kick", "drift-kick-drift", "reversible steps"}) {
        INFO(name);
        CHECK(run_reversal(name, 1).velocity_error < 1e-11);  // measured 2.4e-12 to 5.6e-12
        CHECK(run_reversal(name, 5, 500).velocity_error < 1e-11);
    }
    const ReversalRun fixed = run_reversal("fixed point", 5, 500);
    CHECK(fixed.bitwise);
    CHECK(fixed.velocity_error == 0);
    // What stands still returns, too: the run must be the one with floating-point numbers. Fails if the
    // quantum multiplies where it should divide.
    const ReversalRun floating = run_reversal("drift-kick-drift", 5, 500);
    double apart = 0, fastest = 0;
    for (std::size_t i = 0; i < fixed.v.size(); ++i) {
        apart = std::max({apart, std::abs(fixed.v[i] - floating.v[i]), std::abs(fixed.x[i] - floating.x[i])});
        fastest = std::max(fastest, std::abs(fixed.v[i]));
    }
    CHECK(fastest > 0.04);  // the amplitude is 0.05
    CHECK(apart < 2e-12);   // measured 1.9e-13
    CHECK_THROWS_AS(run_reversal("euler", 1), std::invalid_argument);
}

TEST_CASE("hard case: steps that follow the present state, and RK4, do not return") {
    CHECK(run_reversal("naive steps", 5).velocity_error > 1e-5);  // measured 2.7e-4
    CHECK(run_reversal("RK4", 5).velocity_error > 1e-6);          // measured 7.9e-5
}

TEST_CASE("modes 1 and 2 of a star are exact for any N, mode 3 is of second order") {
    for (const std::size_t n : {20UL, 50UL}) {
        StarScene scene;
        scene.n = n;
        const GasMethod cubic{"consistent-h", "cubic", 1.2};
        for (const double gamma : {1.4, 2.0}) {
            scene.gamma = gamma;
            for (const int mode : {1, 2}) {
                const double omega = run_mode(scene, cubic, mode, 1, 0.01).omega;
                INFO("N = " << n << ", gamma = " << gamma << ", mode " << mode);
                CHECK(std::abs(omega / exact::toy_star_frequency(gamma, mode) - 1) < 1e-8);
            }
        }
    }
    const auto third = [](std::size_t n) {
        StarScene scene;
        scene.n = n;
        scene.spacing = Spacing::even;
        return star_frequencies(scene, {"consistent-h", "cubic", 1.2}, 3)[2] /
                   exact::toy_star_frequency(2, 3) -
               1;
    };
    const double order = std::log2(third(50) / third(100));
    CHECK(order > 1.8);  // measured 1.98
    CHECK(order < 2.2);
}

TEST_CASE("mode 20 of a star of 200: graded spacing and a kernel of fourth order") {
    StarScene scene;
    scene.n = 200;
    const auto error = [&](const GasMethod& scheme) {
        return std::abs(star_frequencies(scene, scheme, 20)[19] / exact::toy_star_frequency(2, 20) - 1);
    };
    CHECK(error({"consistent-h", "super-gaussian", 1.2}) < 3e-3);  // measured 1.6e-3; at N = 400 3.7e-5
    CHECK(error({"consistent-h", "cubic", 1.2}) > 5e-3);
    CHECK(error({"without-omega", "cubic", 1.2}) < 1e-3);  // gamma = 2: its error of second order vanishes
    scene.gamma = 1.4;
    CHECK(star_frequencies(scene, {"consistent-h", "super-gaussian", 1.2}, 1)[0] == 0);  // unstable
}

TEST_CASE("hard case: with one h a star's pulsation does not converge") {
    const auto error = [](std::size_t n, const std::string& resolution) {
        StarScene scene;
        scene.n = n;
        scene.spacing = Spacing::even;
        return std::abs(
            star_frequencies(scene, {resolution, "cubic", 1.2}, 2)[1] / exact::toy_star_frequency(2, 2) - 1);
    };
    CHECK(error(100, "fixed-h") > 0.01);  // measured 0.0140; at N = 50 0.0128
    CHECK(error(100, "fixed-h") > 0.9 * error(50, "fixed-h"));
    CHECK(error(100, "consistent-h") < 1e-6);  // the Jacobian's rounding
}

TEST_CASE("a star that swings to half and to 1.7 times its radius") {
    StarScene scene;
    scene.n = 100;
    const exact::ToyStar star{2, scene.state().K, 1, 1, 1, 1};
    const NonlinearRun best = run_nonlinear(scene, {"consistent-h", "super-gaussian", 1.2}, 1, star.period());
    CHECK(best.radius_error < 1e-4);  // measured 1.8e-5
    CHECK(best.energy_drift < 2e-5);
    CHECK(std::abs(best.momentum) < 1e-14);
    const NonlinearRun without = run_nonlinear(scene, {"without-omega", "cubic", 1.2}, 1, star.period());
    CHECK(without.energy_drift > 1e-3);  // measured 9e-3
    CHECK(without.radius_error > 1e-3);
}

TEST_CASE("leapfrog's energy oscillates as dt^2 and does not drift; naive steps drift") {
    StarScene scene;
    scene.n = 50;
    const EnergyHistory coarse = run_star_energy(scene, "kick-drift-kick", 0.3, 0.4, 4000);
    const EnergyHistory fine = run_star_energy(scene, "kick-drift-kick", 0.3, 0.2, 8000);
    const double order = std::log2(coarse.amplitude / fine.amplitude);
    CHECK(order > 1.95);  // measured 2.00
    CHECK(order < 2.05);
    CHECK(std::abs(fine.drift) < 0.01 * fine.amplitude);
    CHECK(fine.momentum < 1e-13);
    const EnergyHistory naive = run_star_energy(scene, "naive steps", 0.3, 0.2, 8000);
    CHECK(std::abs(naive.drift) > 10 * std::abs(fine.drift));
}

// Fails with the sign of the acceleration changed, or if RK4 is given as many steps as leapfrog.
TEST_CASE("an eccentric orbit: leapfrog keeps its shape and turns it, RK4 spirals inwards") {
    const OrbitRun leapfrog = run_orbit({.periods = 20});
    CHECK(std::abs(leapfrog.energy.back()) < 1e-8);  // measured 2e-11
    CHECK(leapfrog.angular_momentum < 1e-12);
    CHECK(leapfrog.turn < -0.05);  // measured -0.065
    CHECK(leapfrog.turn > -0.08);
    const OrbitRun runge = run_orbit({.periods = 20, .integrator = "RK4"});
    CHECK(runge.energy.back() > 0.03);  // measured 0.05
    CHECK(runge.energy.back() < 0.08);
    // A quarter of the step: the error of a method of fourth order that drifts falls by 4^5.
    const OrbitRun fine = run_orbit({.evaluations = 1600, .periods = 20, .integrator = "RK4"});
    CHECK(runge.energy.back() / fine.energy.back() > 500);
    CHECK(runge.energy.back() / fine.energy.back() < 2000);
    CHECK_THROWS_AS(run_orbit({.integrator = "euler"}), std::invalid_argument);
}

// Fails (order 2) with the halves of drift-kick-drift, 1/24 and 1/12 exchanged, or with df/dt of one step
// only.
TEST_CASE("leapfrog's shadow Hamiltonian is constant to dt^4") {
    StarScene scene;
    scene.n = 50;
    const EnergyHistory coarse = run_star_energy(scene, "kick-drift-kick", 0.3, 0.4, 1000);
    const EnergyHistory fine = run_star_energy(scene, "kick-drift-kick", 0.3, 0.2, 2000);
    const double order = std::log2(coarse.shadow / fine.shadow);
    CHECK(order > 3.8);
    CHECK(order < 4.2);
    CHECK(coarse.shadow < 0.01 * coarse.amplitude);
}

TEST_CASE("hard case: a star with the force (3.5) walks away") {
    StarScene scene;
    scene.n = 100;
    scene.spacing = Spacing::masses;
    const CentreRun run = run_centres(scene, 0.2, 30);
    double naive = 0, conserving = 0;
    for (const double x : run.centre) naive = std::max(naive, std::abs(x));
    for (const double x : run.conserving_centre) conserving = std::max(conserving, std::abs(x));
    CHECK(naive > 0.01);        // measured 0.036
    CHECK(conserving < 1e-13);  // measured 1e-15
    CHECK(run.momentum > 1e-3);
}

TEST_CASE("gas that expands into the vacuum") {
    const auto run = [](std::size_t n, const std::string& resolution, bool graded = false) {
        RarefactionScene scene;
        scene.n = n;
        scene.graded = graded;
        return run_rarefaction(scene, {resolution, "cubic", 1.2});
    };
    const RarefactionRun gas = run(200, "consistent-h");
    CHECK(gas.velocity_error < 0.005);  // measured 0.0036
    CHECK(gas.velocity_error > 0.002);
    CHECK(std::abs(gas.energy_drift) < 1e-5);
    CHECK(std::abs(gas.momentum) < 1e-13);
    CHECK(run(200, "consistent-h", true).velocity_error < 0.0025);  // measured 0.0016
    const double order = std::log2(run(100, "consistent-h").velocity_error / gas.velocity_error);
    CHECK(order > 0.7);  // measured 0.88
    CHECK(order < 1.3);
    CHECK(run(200, "without-omega").velocity_error > 0.005);  // measured 0.0060, and it stays
}

TEST_CASE("hard case: with one h a rarefaction loses its particles") {
    RarefactionScene scene;
    const RarefactionRun gas = run_rarefaction(scene, {"fixed-h", "cubic", 1.2});
    CHECK(gas.velocity_error > 0.2);  // measured 0.316 for any N
    CHECK(run_rarefaction(scene, {"consistent-h", "cubic", 1.2}).velocity_error < 0.005);
}

TEST_CASE("circulation of tracers: error as the square of their distance; carried tracers lose it") {
    const auto run = [](std::size_t tracers) {
        NecklaceScene scene;
        scene.per_side = 32;
        scene.tracers = tracers;
        scene.time = 0.5;
        return run_necklace(scene);
    };
    const NecklaceRun coarse = run(64), fine = run(128);
    const double order = std::log2(coarse.drift / fine.drift);
    CHECK(order > 1.8);  // measured 2.0
    CHECK(order < 2.2);
    CHECK(fine.drift < 1e-3);
    CHECK(fine.carried_drift > 10 * fine.drift);
}

TEST_CASE("a liquid square conserves energy, momentum and angular momentum; two threads give the same bits") {
    PatchScene scene;
    scene.per_side = 20;
    scene.time = 0.3;
    const PatchRun one = run_patch(scene);
    CHECK(one.energy_drift < 1e-6);  // RK4; measured 1e-9
    CHECK(one.momentum < 1e-13);
    CHECK(one.angular_momentum < 1e-13);
    CHECK(one.compression < 0.05);
    CHECK(one.compression > 0.001);
    scene.threads = 2;
    const PatchRun two = run_patch(scene);
    CHECK(two.x == one.x);
    CHECK(two.pressure == one.pressure);
}

TEST_CASE("random points relax to an ordered star; wide kernels pair") {
    DiscScene scene;
    scene.n = 300;
    scene.time = 15;
    const DiscRun star = run_disc(scene);
    CHECK(star.density_error < 0.03);
    CHECK(star.density_error > 0.003);
    CHECK(star.nearest > 0.85);  // measured 0.98 spacings
    CHECK(star.gradient_error < 0.7 * star.random_gradient_error);
    CHECK(star.momentum < 1e-5);
    scene.h_over_dx = 1.5;
    CHECK(run_disc(scene).nearest < 0.5);
}

TEST_CASE("the Lagrangian grid is of second order on the wave") {
    const auto error = [](std::size_t n) {
        WaveScene scene;
        LagrangianGrid<Polytrope> grid{scene.state(), 1, 0};
        for (std::size_t k = 0; k < n; ++k) {
            grid.x.push_back(static_cast<double>(k) / static_cast<double>(n));
            grid.v.push_back(scene.velocity(grid.x.back(), 0));
            grid.m.push_back(1 / static_cast<double>(n));
        }
        double t = 0;
        march(grid, t, {.end = 0.125, .steps = static_cast<long>(5 * n / 8)});
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum += std::abs(grid.v[k] - scene.velocity(grid.x[k], 0.125)) /
                   (scene.amplitude * static_cast<double>(n));
        return sum;
    };
    const double order = std::log2(error(32) / error(64));
    CHECK(order > 1.9);
    CHECK(order < 2.1);
}
