// Godunov SPH in the plane and in space: what is conserved, what half a step across a pair's line is for, and
// the schemes beside the paper's.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "chapters/01_kernel_interpolation/gaussians.hpp"
#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"
#include "chapters/07_godunov_sph/scenes/gresho.hpp"
#include "chapters/07_godunov_sph/scenes/sedov.hpp"
#include "chapters/07_godunov_sph/scenes/sliding.hpp"
#include "common/core/unstable.hpp"

using namespace sph;
using namespace sph::godunov;

TEST_CASE("a vortex keeps energy and momentum to rounding, and does not see the number of threads") {
    // Measured: 1e-15 and 3e-16. Fails for heats that take the velocity of the step's beginning (1e-4).
    const GreshoScene scene{.time = 0.1, .n = 16};
    for (const char* name : {"inutsuka", "first-order", "godunov", "geometric-volume"}) {
        const GreshoRun run = run_gresho(scene, plane_methods()[name]);
        INFO(name);
        CHECK(run.energy_drift < 1e-13);
        CHECK(run.momentum_drift < 1e-13);
    }
    GreshoScene two = scene;
    two.threads = 2;
    CHECK(run_gresho(scene, plane_methods()["godunov"]).v == run_gresho(two, plane_methods()["godunov"]).v);
}

TEST_CASE("half a step across the line between particles is no viscosity in shear") {
    // Measured: 0.006 and 0.060 c_s h; less than a tenth and more than 0.05 are asked. Fails for `across` of
    // the wrong sign or without the factor 1/2.
    const shocks::ShearScene scene{.time = 0.5, .n = 32};
    const auto viscosity = [&](const char* name) {
        const shocks::ShearRun run = run_shear(scene, plane_methods()[name]);
        return run.viscosity / run.h;
    };
    const double with = viscosity("godunov"), without = viscosity("along-line");
    CHECK(with < 0.2 * without);
    CHECK(without > 0.04);
}

TEST_CASE("streams slide into waves that grow nearly as the linear theory says") {
    // Measured: 0.5 of the theory with 20 particles in the side, 0.1 without half steps across. Fails for a
    // mode that is a mirror image, or a growth that is fitted to its logarithm to the base 10.
    const SlidingRun run = run_sliding({.n = 20}, plane_methods()["godunov"]);
    CHECK(run.growth > 0.35 * run.theory);
    CHECK(run.growth < run.theory);
    CHECK(run.energy_drift < 1e-13);
    CHECK(run.amplitude.front() == 1);
    const SlidingRun grid = run_sliding_grid({.n = 48});
    CHECK(grid.growth == Approx(grid.theory).epsilon(0.04));  // measured: 0.98
}

TEST_CASE("the paper's scheme does not survive Noh's problem in the plane, this chapter's does") {
    // Its first long step leaves a negative energy. Fails where steps are taken back: then they crawl
    // instead.
    const shocks::NohScene scene{.n = 12};
    std::string reason;
    try {
        run_noh(scene, plane_methods()["inutsuka"]);
    } catch (const Unstable& stopped) {
        reason = stopped.what();
    }
    CHECK(reason.find("thermal energy") != std::string::npos);
    const shocks::NohRun run = run_noh(scene, plane_methods()["godunov"]);
    CHECK(run.energy_drift < 1e-12);
    CHECK(run.plateau > 8);  // measured: 9.2 of 16
}

TEST_CASE("the narrow kernel's density answers a compression rightly on a line only") {
    // - sum_j x dW/dx over a lattice, 1 where a sum is exact: measured 1 and 0.9736, for the wide Gaussian
    // 0.998. Fails for kernels of another width.
    const auto answer = [](auto kernel, int rows) {
        double sum = 0;
        for (int x = -6; x <= 6; ++x) {
            for (int y = -rows; y <= rows; ++y) sum -= x * x * kernel.F(std::hypot(x, y), 1.0);
        }
        return sum;
    };
    CHECK(answer(QuadraticSpline<1>{}, 0) == Approx(1).epsilon(1e-14));
    CHECK(answer(QuadraticSpline<2>{}, 6) == Approx(0.9736).epsilon(1e-4));
    CHECK(std::abs(answer(Gaussian<2>{}, 6) - 1) < 0.003);
}

TEST_CASE("a blast on a line, in the plane and in space reaches the exact radius") {
    // Measured: 0.400, 0.403 and 0.42. Fails for the energy of the whole space in its part between mirrors.
    const BlastRun<1> line = run_blast<1>({.n = 100}, line_methods()["godunov"]);
    CHECK(line.shock == Approx(0.4).epsilon(0.02));
    const BlastRun<2> plane = run_blast<2>({.blast_width = 2, .n = 20}, plane_methods()["godunov"]);
    CHECK(plane.shock == Approx(0.4).epsilon(0.05));
    CHECK(plane.energy_drift < 1e-12);
    const BlastRun<3> space = run_blast<3>({.blast_width = 2, .n = 12}, space_methods()["godunov"]);
    CHECK(space.shock == Approx(0.4).epsilon(0.12));
    CHECK(space.energy_drift < 1e-12);
}
