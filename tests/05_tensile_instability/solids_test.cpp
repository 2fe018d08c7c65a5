// Elastic solids: waves, a plate, colliding rings, a rotating wheel and a disc. Each scheme that fails is the
// negative control of the check that its cure passes.
#include <catch2/catch.hpp>

#include "chapters/05_tensile_instability/scenes/elastic_disc.hpp"
#include "chapters/05_tensile_instability/scenes/elastic_grid.hpp"
#include "chapters/05_tensile_instability/scenes/plate.hpp"
#include "chapters/05_tensile_instability/scenes/rings.hpp"
#include "chapters/05_tensile_instability/scenes/wheel.hpp"
#include "common/core/unstable.hpp"
#include "common/report/norms.hpp"

using namespace sph;
using namespace sph::tensile;

namespace {

double wave_error(const char* method, Polarisation polarisation, std::size_t n) {
    const ElasticWaveRun wave =
        run_elastic_wave({.polarisation = polarisation, .n = n}, solid_methods()[method]);
    CHECK(wave.momentum_drift < 1e-13);  // measured 1.7e-15
    return wave.error;
}
double wave_order(const char* method, Polarisation polarisation, std::size_t n) {
    return report::observed_order(static_cast<double>(n), wave_error(method, polarisation, n),
                                  static_cast<double>(2 * n), wave_error(method, polarisation, 2 * n));
}
double sum_of(const Column& column) {
    double sum = 0;
    for (const double value : column) sum += value;
    return sum;
}
WheelRun wheel_of(const char* method, double turns, double rim = 0.1) {
    WheelScene scene;
    scene.turns = turns;
    scene.rim = rim;
    return run_wheel(scene, solid_methods()[method]);
}

}  // namespace

// Fails for 2 mu/3 in c_l (1.04 c_t), for a force without B_j, and for a step of the first order.
TEST_CASE("P and S waves run at c_l and c_t, with second order in the total Lagrangian solid") {
    for (const Polarisation wave : {Polarisation::longitudinal, Polarisation::transverse}) {
        CHECK(wave_error("total-lagrangian", wave, 32) < 0.032);  // measured 0.0303, 0.0309
        const double order = wave_order("total-lagrangian", wave, 32);
        CHECK(order > 1.95);  // measured 2.001, 2.001
        CHECK(order < 2.05);
        // The sums of (11.6) as printed do not see a linear velocity rightly: a floor, for any N.
        CHECK(wave_order("jaumann", wave, 64) < 0);  // measured -0.81, -0.82
        // But the law itself is right: the printed form of 11.3 with 1/3 left out is off by 0.1 and more.
        CHECK(wave_error("jaumann", wave, 32) < 0.036);  // measured 0.0326, 0.0331
    }
}

// Fails for lambda without 2 mu in sigma_xx, for sigma_xy of one slope only, and for a full first kick.
TEST_CASE("the grid that solids are compared with: second order, and closer than particles") {
    for (const Polarisation polarisation : {Polarisation::longitudinal, Polarisation::transverse}) {
        const auto error = [&](std::size_t n) {
            return run_grid_elastic_wave({.polarisation = polarisation, .n = n}).error;
        };
        const double coarse = error(16), fine = error(32);
        const double order = report::observed_order(16, coarse, 32, fine);
        CHECK(order > 1.95);  // measured 2.00, 2.00
        CHECK(order < 2.05);
        CHECK(fine < 0.008);  // measured 0.0070, 0.0076
        CHECK(fine < 0.5 * wave_error("total-lagrangian", polarisation, 32));
    }
}

TEST_CASE("a clamped plate: its first frequency converges, and is within 3 % from 4 rows on") {
    double last = 0.03;
    for (const std::size_t rows : {4, 6, 8}) {
        const PlateRun plate = run_plate({.rows = rows}, solid_methods()["total-lagrangian"]);
        CHECK(plate.frequency < 1);
        CHECK(1 - plate.frequency < last);  // measured 0.0241, 0.0130, 0.0082
        last = 0.7 * (1 - plate.frequency);
    }
    // A strain that is smoothed over many neighbours is too small in the outer rows, whatever the law.
    const auto frequency = [](const SolidMethod& method) { return run_plate({.rows = 4}, method).frequency; };
    CHECK(frequency(solid_methods()["jaumann"]) < 0.75);                       // measured 0.67
    CHECK(frequency(with_h("total-lagrangian", "wide", 1.5)) < 0.8);           // measured 0.73
    CHECK(std::abs(frequency(with_h("jaumann", "narrow", 0.75)) - 1) < 0.03);  // measured 0.9895
}

TEST_CASE("few neighbours are no cure where they change: the printed rings fall to pieces") {
    CHECK(run_rings({}, with_h("jaumann", "narrow", 0.75)).pieces > 20);                    // measured 68
    CHECK_THROWS_AS(run_rings({}, with_h("artificial-stress", "narrow", 0.75)), Unstable);  // measured at 22
}

// Fails for E in place of E/(1 - nu^2), 1.19.
TEST_CASE("a loaded beam comes to rest where w L^3/(3 E' I) is, the nearer the more rows") {
    const BeamRun coarse = run_beam({.rows = 3}), fine = run_beam({.rows = 6});
    CHECK(coarse.speed < 1e-2);  // it rests
    CHECK(fine.speed < 1e-2);
    CHECK(fine.deflection > 1.015);  // measured 1.0256
    CHECK(fine.deflection < 1.035);
    CHECK(coarse.deflection - 1 > 3 * (fine.deflection - 1));
}

TEST_CASE("rings tear without artificial stress and bounce with it; momentum is exact either way") {
    const RingsRun naive = run_rings({}, solid_methods()["jaumann"]);
    const RingsRun cured = run_rings({}, solid_methods()["artificial-stress"]);
    CHECK(naive.pieces > 3);         // measured 6
    CHECK(naive.rebound < 0.3);      // measured 0.04
    CHECK(cured.pieces == 2);        // fails for epsilon = 0, and for R along the axes of pressure
    CHECK(cured.rebound > 0.6);      // measured 0.72
    CHECK(cured.energy_left > 0.7);  // measured 0.80; what viscosity takes
    CHECK(cured.energy_gain < 1e-3);
    CHECK(naive.momentum_drift < 1e-13);  // measured 2e-15
    CHECK(cured.momentum_drift < 1e-13);
}

// (11.6) as printed in our copy has + Pi where it must be - Pi delta.
TEST_CASE("viscosity with the sign of the printed (11.6) heats motion up") {
    SolidSetup setup{.n = 2, .matter = {1, 0.4, 1}, .dx = 1};
    const auto left_after = [&](double alpha) {
        setup.alpha = alpha;
        const auto solid = make_solid(setup, solid_methods()["jaumann"]);
        solid->place(0, {0, 0}, {0.01, 0}, 1, 1, 0);
        solid->place(1, {1, 0}, {-0.01, 0}, 1, 1, 0);
        solid->start(0);
        double t = 0;
        const double first = solid->totals().energy;
        march(*solid, t, {.end = 1});
        return solid->totals().energy / first;
    };
    CHECK(left_after(0.5) < 1);
    CHECK(left_after(-0.5) > 1);
}

// The wheel's numbers that the book promises.
TEST_CASE("the rotating wheel: as printed it loses its rotation, total Lagrangian it keeps every digit") {
    const WheelRun printed = wheel_of("jaumann", 1);
    CHECK(printed.after_one < -0.5);  // measured -0.98
    const WheelRun smoothed = wheel_of("strong-xsph", 2);
    CHECK(std::abs(smoothed.after_half) < 0.6 * std::abs(printed.after_half));  // measured 0.047 and 0.139
    CHECK(smoothed.loss > 0.5);
    const WheelRun corrected = wheel_of("corrected-rate", 3);
    CHECK(corrected.loss < 1e-3);   // measured 4e-5
    CHECK(corrected.loss > 1e-12);  // the forces are not central: no accident makes it exact
    const WheelRun exact = wheel_of("total-lagrangian", 10);
    CHECK(exact.turns > 9.99);
    CHECK(exact.loss < 1e-12);                                  // measured 2.7e-15
    CHECK(exact.energy_drift < 1e-4);                           // measured 9.4e-6
    CHECK(exact.momentum_drift < 1e-13);                        // measured 5e-16
    CHECK(wheel_of("total-lagrangian", 10, 0.3).loss < 1e-12);  // strains of ten per cent
}

TEST_CASE("a relaxed disc with a radial velocity: torn as printed, whole when cured") {
    const ElasticDiscRun printed = run_elastic_disc({}, solid_methods()["jaumann"]);
    CHECK(printed.pieces.count > 2);  // measured 4
    CHECK(printed.largest_share < 0.9);
    const ElasticDiscRun cured = run_elastic_disc({}, solid_methods()["artificial-stress"]);
    CHECK(cured.pieces.count == 1);
    CHECK(cured.energy_left < 0.3);  // measured 0.07: whole, but at rest
    const ElasticDiscRun exact = run_elastic_disc({}, solid_methods()["total-lagrangian"]);
    CHECK(exact.pieces.count == 1);
    CHECK(exact.reached == 40);
    CHECK(exact.energy_left == Approx(1).margin(0.03));  // measured 1.008
    // Corrected gradients alone do not cure tension.
    CHECK(run_elastic_disc({}, solid_methods()["corrected-rate"]).reached < 40);  // measured 5.5
}

TEST_CASE("a solid is bitwise the same for one and two threads") {
    for (const char* method : {"artificial-stress", "total-lagrangian"}) {
        WheelScene scene{.across = 10, .turns = 0.1};
        const WheelRun one = run_wheel(scene, solid_methods()[method]);
        scene.threads = 2;
        CHECK(one.x == run_wheel(scene, solid_methods()[method]).x);
    }
}

TEST_CASE("pieces: particles that are linked, directly or not") {
    Columns<2> x;
    x[0] = {0, 1, 2, 5, 5.5, 9};
    x[1] = {0, 0, 0, 0, 0.5, 0};
    const Pieces pieces = pieces_of(x, 1);
    CHECK(pieces.count == 3);
    CHECK(pieces.largest == 3);
    CHECK(pieces_of(x, 4).count == 1);
}

TEST_CASE("a relaxed disc is even: no two particles closer than 0.7 of the spacing, nobody outside") {
    const std::size_t n = 300;
    const Columns<2> x = relaxed_disc(n, 1);
    double nearest = 1, farthest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        farthest = std::max(farthest, std::hypot(x[0][i], x[1][i]));
        for (std::size_t j = 0; j < i; ++j)
            nearest = std::min(nearest, std::hypot(x[0][i] - x[0][j], x[1][i] - x[1][j]));
    }
    const double dx = std::sqrt(std::acos(-1) / static_cast<double>(n));
    CHECK(nearest > 0.7 * dx);
    CHECK(farthest < 1 - 0.49 * dx);
    CHECK(std::abs(sum_of(x[0])) < 0.05 * static_cast<double>(n) * dx);
}
