// Artificial viscosity in the plane: shocks that run across the rows of particles, and shear.
#include <algorithm>
#include <catch2/catch.hpp>

#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/sedov_plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "common/core/unstable.hpp"

using namespace sph;
using namespace sph::shocks;

namespace {

NohScene noh_scene(std::size_t n) {
    NohScene scene;
    scene.n = n;
    return scene;
}

}  // namespace

TEST_CASE(
    "Noh in the plane: what is behind the shock, and the error falls with N; without viscosity it breaks") {
    const NohRun coarse = run_noh(noh_scene(20), plane_methods()["signal"]);
    CHECK(coarse.plateau > 10.3);  // measured 10.74; 16 is exact
    CHECK(coarse.plateau < 11.2);
    CHECK(coarse.l1_rho < 0.44);  // measured 0.424
    const NohRun fine = run_noh(noh_scene(40), plane_methods()["signal"]);
    CHECK(fine.plateau > 13.7);  // measured 14.03
    CHECK(fine.plateau < 14.3);
    CHECK(fine.l1_rho < 0.20);  // measured 0.187
    CHECK(fine.l1_rho > 0.17);
    CHECK(fine.energy_drift < 1e-12);  // measured 6e-15
    // Fails if rings are twice as wide (0.2247), or if the level is half of the measured plateau (0.2245).
    CHECK(fine.shock > 0.2200);  // measured 0.2215; 0.2 is exact, and 0.2185 what the mass behind it takes
    CHECK(fine.shock < 0.2230);
    CHECK(coarse.shock > fine.shock);
    CHECK_THROWS_AS(run_noh(noh_scene(20), plane_methods()["none"]), Unstable);
}

TEST_CASE("reconstruction in the plane: a smaller error than the signal viscosity, and a cooler centre") {
    const NohRun signal = run_noh(noh_scene(32), plane_methods()["signal"]);
    const NohRun best = run_noh(noh_scene(32), plane_methods()["reconstructed"]);
    CHECK(best.l1_rho < 0.85 * signal.l1_rho);  // measured 0.196 and 0.248
    CHECK(best.l1_rho > 0.6 * signal.l1_rho);
    CHECK(best.centre > 1.4 * signal.centre);  // measured 9.1 and 5.4; 16 is exact
    CHECK(best.energy_drift < 1e-12);          // measured 6e-15
}

TEST_CASE("a quarter between mirrors is the whole plane; only the square lattice has mirrors") {
    NohScene scene = noh_scene(12);
    const NohRun quarter = run_noh(scene, plane_methods()["balsara"]);
    scene.quarter = false;
    const NohRun whole = run_noh(scene, plane_methods()["balsara"]);
    CHECK(std::abs(whole.l1_rho - quarter.l1_rho) <
          1e-9);                          // rounding of sums in other orders; measured 4e-16
    CHECK(whole.momentum_drift < 1e-14);  // measured 2e-17
    CHECK(whole.energy_drift < 1e-12);    // measured 4e-15
    scene.quarter = true;
    scene.lattice = Lattice::hexagonal;
    CHECK_THROWS_AS(run_noh(scene, plane_methods()["balsara"]), std::invalid_argument);
}

TEST_CASE("Sedov's blast: where the shock is, and conservation, on both lattices") {
    SedovScene scene;
    scene.n = 24;
    const SedovRun quarter = run_sedov(scene, plane_methods()["signal"]);
    CHECK(std::abs(quarter.shock_radius / 0.4 - 1.032) < 0.01);  // measured 0.4128
    CHECK(quarter.l1_rho < 0.23);                                // measured 0.216
    CHECK(quarter.energy_drift < 1e-12);                         // measured 3e-15
    scene.n = 16;
    scene.quarter = false;
    scene.lattice = Lattice::hexagonal;
    const SedovRun whole = run_sedov(scene, plane_methods()["reconstructed"]);
    CHECK(std::abs(whole.shock_radius / 0.4 - 1.030) < 0.01);  // measured 0.4118
    CHECK(whole.energy_drift < 1e-12);                         // measured 2e-14
    CHECK(whole.momentum_drift < 1e-14);                       // measured 3e-17
}

TEST_CASE(
    "hard case: a blast without viscosity, or with too little, ends in steps that collapse, and says so") {
    SedovScene scene;
    scene.n = 24;
    scene.most_steps = 600;  // runs that finish need 119 to 131
    CHECK_THROWS_AS(run_sedov(scene, plane_methods()["none"]), Unstable);
    CHECK_THROWS_AS(run_sedov(scene, plane_methods()["colagrossi"]), Unstable);
    CHECK_NOTHROW(run_sedov(scene, plane_methods()["balsara"]));
}

TEST_CASE("where the means of rings first rise through a level, coming from outside") {
    const Rings rings{{1, 2, 3, 4, 5}, {9, 1, 9, 3, 2}};
    CHECK(outermost_rise(rings, 6) == Approx(3.5));  // fails if the innermost place is taken: 1.375
    CHECK(outermost_rise(rings, 2.5) == Approx(4.5));
    CHECK(outermost_rise(rings, 10) == 0);
    CHECK(outermost_rise({{1, 2}, {7, 8}}, 6) == 0);  // above it all the way: no rise
}

TEST_CASE("the grid, for comparison: Noh and Sedov") {
    const NohRun noh = run_noh_grid(noh_scene(40), 40);
    CHECK(noh.r.size() == 1600);
    CHECK(*std::max_element(noh.x[0].begin(), noh.x[0].end()) == Approx(1 - 0.5 / 40));
    CHECK(noh.l1_rho < 0.050);  // measured 0.0458
    CHECK(noh.l1_rho > 0.042);  // 0.022 if the cells lie where the gas is at the end, in (0, 0.4)^2
    CHECK(noh.plateau > 15.2);  // measured 15.4
    CHECK(noh.plateau < 15.6);
    CHECK(noh.shock > 0.205);  // measured 0.2077
    CHECK(noh.shock < 0.210);
    SedovScene scene;
    scene.n = 40;
    CHECK(run_sedov_grid(scene).l1_rho < 0.13);  // measured 0.121
}

TEST_CASE("a shear is left alone by the factors and by reconstruction, and not by alpha and beta") {
    ShearScene scene;
    scene.n = 24;
    scene.time = 2;
    const auto effective = [&](const char* name) {
        const ShearRun run = run_shear(scene, plane_methods()[name]);
        CHECK(run.momentum_drift < 1e-13);  // measured 2e-15
        CHECK(run.energy_drift < 1e-10);    // of the wave's, a part in 360 of all; measured 5e-12
        return run.viscosity / run.h;       // in c_s h
    };
    // Half the pairs of a shear approach: 1/16 by (8.7), less what few neighbours lose (pairwise viscosity).
    const double alpha_beta = effective("alpha-beta");
    CHECK(alpha_beta > 0.053);  // measured 0.0555
    CHECK(alpha_beta < 0.0625);
    CHECK(effective("signal") > 0.048);                // measured 0.0523
    CHECK(std::abs(effective("none")) < 0.004);        // measured -0.0022: the lattice gives way, elastically
    CHECK(std::abs(effective("balsara")) < 0.004);     // measured -0.0022
    CHECK(std::abs(effective("colagrossi")) < 0.004);  // measured -0.0021
    CHECK(std::abs(effective("reconstructed")) < 0.004);  // measured 0.0003
    CHECK(effective("none-cubic") > 0.006);               // measured 0.0096: nothing that is listed does this
}

TEST_CASE("equal results for one and two threads, in the plane") {
    NohScene scene = noh_scene(16);
    const NohRun one = run_noh(scene, plane_methods()["reconstructed"]);
    scene.threads = 2;
    const NohRun two = run_noh(scene, plane_methods()["reconstructed"]);
    CHECK(one.x == two.x);
    CHECK(one.rho == two.rho);
    CHECK(one.v == two.v);
}
