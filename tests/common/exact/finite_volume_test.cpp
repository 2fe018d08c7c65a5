// The finite-volume solver in one dimension: accuracy, and what it keeps exactly.
#include "common/exact/finite_volume.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/common/exact/finite_volume_reference.hpp"

using namespace finite_volume_reference;

namespace {

/// Cells of a periodic row in 0..1: of one width; graded, the widest three times the narrowest; or wide ones
/// and narrow ones by turns, of the same ratio.
enum class Widths { equal, graded, alternating };
GasCells periodic_cells(std::size_t n, Widths widths) {
    GasCells cells = exact::uniform_cells(0, 1, n, {1, 1, 1});
    for (std::size_t i = 1; i < n; ++i) {
        double& x = cells.faces[i];
        if (widths == Widths::graded) x += 0.5 / two_pi * std::sin(two_pi * x);
        if (widths == Widths::alternating && i % 2 == 1) x += 0.5 / static_cast<double>(n);
    }
    return cells;
}

double mean_sine(double a, double b) {
    return (std::cos(two_pi * a) - std::cos(two_pi * b)) / (two_pi * (b - a));
}

/// A sound wave of amplitude 1e-6 in a wind of speed 1 after one period, or a density wave of amplitude 0.2
/// that the wind carries: L1 error over L1.
double wave_error(Frame frame, bool sound, std::size_t n, Widths widths) {
    const double gamma = 1.4, c = std::sqrt(gamma), size = sound ? 1e-6 : 0.2;
    GasCells cells = periodic_cells(n, widths);
    for (std::size_t i = 0; i < n; ++i) {
        const double wave = size * mean_sine(cells.faces[i], cells.faces[i + 1]);
        cells.states[i] =
            sound ? Riemann::State{1 + wave, 1 + c * wave, 1 + gamma * wave} : Riemann::State{1 + wave, 1, 1};
    }
    FiniteVolume solution{cells, options(frame, gamma, End::periodic)};
    const double speed = sound ? 1 + c : 1, time = 1 / speed;
    solution.advance_to(time);
    cells = solution.cells();
    double wrong = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double wave =
            size * mean_sine(cells.faces[i] - speed * time, cells.faces[i + 1] - speed * time);
        const double found = sound ? (cells.states[i].v - 1) / c : cells.states[i].rho - 1;
        wrong += std::abs(found - wave) * cells.width(i);
    }
    return wrong / (size * 4 / two_pi);
}

void check_wave(Frame frame, bool sound, Widths widths, double error_32) {
    CAPTURE(frame == Frame::eulerian, sound, static_cast<int>(widths));
    const double coarse = wave_error(frame, sound, 32, widths), fine = wave_error(frame, sound, 64, widths);
    CAPTURE(coarse, fine);
    CHECK(coarse == Approx(error_32).epsilon(0.05));
    CHECK(std::log2(coarse / fine) > 1.7);
    CHECK(std::log2(coarse / fine) < 2.25);
}

}  // namespace

// Relative L1 at 200 cells: Eulerian .00363/.00785/.00257 (rho, v, p), Lagrangian .00485/.02326/.00557, where
// only 22 cells hold the thin gas. The errors fall by 1.8 to 1.9 per doubling. Fails without slopes (.0107
// for rho), without the half step, and for slopes that are half as steep.
TEST_CASE("finite volume: first order in L1 on the tube of Sod") {
    const struct {
        Frame frame;
        Errors at_200;
    } known[] = {{Frame::eulerian, {0.00363, 0.00785, 0.00257}},
                 {Frame::lagrangian, {0.00485, 0.02326, 0.00557}}};
    for (const auto& [frame, at_200] : known) {
        CAPTURE(frame == Frame::eulerian);
        const Errors coarse = errors(sod, frame, 200), fine = errors(sod, frame, 800);
        CHECK(coarse.rho == Approx(at_200.rho).epsilon(0.03));
        CHECK(coarse.v == Approx(at_200.v).epsilon(0.03));
        CHECK(coarse.p == Approx(at_200.p).epsilon(0.03));
        const double rate = std::log2(coarse.rho / fine.rho) / 2, rate_p = std::log2(coarse.p / fine.p) / 2;
        CHECK(rate > 0.75);
        CHECK(rate < 1.1);
        CHECK(rate_p > 0.75);
        CHECK(rate_p < 1.1);
    }
}

// Errors at 32 cells as below; per doubling they fall by 2^(1.73 .. 2.06). Fails for slopes that ignore the
// widths of the cells, without the half step, and with a half step in the wrong direction.
TEST_CASE("finite volume: second order on travelling waves, also with cells of several widths") {
    check_wave(Frame::eulerian, true, Widths::equal, 0.00828);
    check_wave(Frame::lagrangian, true, Widths::equal, 0.00484);
    check_wave(Frame::eulerian, false, Widths::equal, 0.0178);
    check_wave(Frame::eulerian, true, Widths::graded, 0.0270);
    check_wave(Frame::lagrangian, true, Widths::graded, 0.0167);
    check_wave(Frame::eulerian, false, Widths::graded, 0.0349);
    check_wave(Frame::eulerian, true, Widths::alternating, 0.0324);
    check_wave(Frame::lagrangian, true, Widths::alternating, 0.0203);
    check_wave(Frame::eulerian, false, Widths::alternating, 0.0396);
}

// Measured: mass and energy to 7e-16, momentum to 4e-17 of the largest possible. Fails if one side of a face
// gets another flux, or one end of a periodic row.
TEST_CASE("finite volume: mass, momentum and energy in a closed box") {
    for (const Frame frame : {Frame::eulerian, Frame::lagrangian}) {
        for (const End ends : {End::reflecting, End::periodic}) {
            CAPTURE(frame == Frame::eulerian, ends == End::reflecting);
            FiniteVolume box{exact::uniform_tube(-0.5, 0, 0.5, 200, blast.left, blast.right),
                             options(frame, blast.gamma, ends)};
            const double mass = box.mass(), energy = box.energy();
            box.advance_to(0.05);  // 20 to 60 times through the box
            CHECK(box.steps() > 1000);
            CHECK(box.mass() == Approx(mass).epsilon(1e-14));
            CHECK(box.energy() == Approx(energy).epsilon(1e-14));
            if (ends == End::periodic) CHECK(std::abs(box.momentum()) < 1e-13 * std::sqrt(2 * energy * mass));
            if (ends == End::reflecting) CHECK(box.cells().faces.back() == Approx(0.5).epsilon(1e-14));
        }
    }
}

// Each cell keeps its mass to 2e-14 and the gas of each side meets at one face, which stands within 4e-5 of
// v_star t. Two cells from it the density is off by 5 % (the start leaves that in the two cells beside it),
// five cells away by 0.2 %. Fails if faces move at another speed than volumes grow.
TEST_CASE("finite volume: in the Lagrangian frame the contact stays sharp") {
    FiniteVolume tube = solver(sod, Frame::lagrangian, 360);
    const GasCells before = tube.cells();
    tube.advance_to(sod.time);
    const GasCells after = tube.cells();
    double worst = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double mass = before.states[i].rho * before.width(i);
        worst = std::max(worst, std::abs(after.states[i].rho * after.width(i) / mass - 1));
    }
    CHECK(worst < 1e-12);
    const std::size_t contact = 320;  // cells of the left gas: eight ninths of the mass
    const Riemann::Star star = Riemann{sod.left, sod.right, sod.gamma}.star();
    CHECK(after.faces[contact] == Approx(star.v * sod.time).margin(1e-3));
    CHECK(after.states[contact - 5].rho == Approx(star.rho_left).epsilon(0.01));
    CHECK(after.states[contact + 4].rho == Approx(star.rho_right).epsilon(0.01));
    CHECK(after.states[contact - 1].rho - after.states[contact].rho > 0.8 * (star.rho_left - star.rho_right));
}

// A contact at rest, and uniform gas that moves, stay what they are. Fails for HLL's flux.
TEST_CASE("finite volume: nothing happens to a contact at rest, and to a wind") {
    for (const Frame frame : {Frame::eulerian, Frame::lagrangian}) {
        FiniteVolume contact{exact::uniform_tube(-0.5, 0, 0.5, 50, {1, 0, 1}, {1e-3, 0, 1}),
                             options(frame, 1.4)};
        contact.advance_to(0.3);
        const GasCells cells = contact.cells();
        for (std::size_t i = 0; i < 50; ++i) {
            CHECK(cells.states[i].rho == Approx(i < 25 ? 1 : 1e-3).epsilon(1e-13));
            CHECK(std::abs(cells.states[i].v) < 1e-13);
        }
        FiniteVolume wind{exact::uniform_cells(0, 1, 50, {2, 3, 1}), options(frame, 1.4)};
        wind.advance_to(1);
        CHECK(wind.cells().faces.front() == Approx(frame == Frame::eulerian ? 0 : 3).margin(1e-13));
        for (const auto& [rho, v, p] : wind.cells().states) {
            CHECK(rho == Approx(2).epsilon(1e-13));
            CHECK(v == Approx(3).epsilon(1e-13));
            CHECK(p == Approx(1).epsilon(1e-12));
        }
    }
}

// A wall is a plane of symmetry: the right half alone, and both halves. Measured: 5e-14. Fails for a wall
// that does not mirror the velocity, or takes the cells in the wrong order.
TEST_CASE("finite volume: a wall mirrors") {
    for (const Frame frame : {Frame::eulerian, Frame::lagrangian}) {
        const auto cells_from = [](double begin, std::size_t n) {
            GasCells cells = exact::uniform_cells(begin, 1, n, {1, 0, 1});
            for (std::size_t i = 0; i < n; ++i) {
                if (std::abs(cells.centre(i)) < 0.3) cells.states[i].p = 5;
            }
            return cells;
        };
        FiniteVolume whole{cells_from(-1, 200), options(frame, 1.4)};
        auto with_wall = options(frame, 1.4);
        with_wall.left = End::reflecting;
        FiniteVolume half{cells_from(0, 100), with_wall};
        whole.advance_to(0.4);
        half.advance_to(0.4);
        double worst = 0;
        for (std::size_t i = 0; i < 100; ++i)
            worst = std::max(worst, std::abs(half.cells().states[i].rho - whole.cells().states[i + 100].rho));
        CHECK(worst < 1e-11);
    }
}

// Fails if steps overshoot, or repeated ones are not counted.
TEST_CASE("finite volume: time and counters") {
    FiniteVolume tube = solver(blast, Frame::lagrangian, 100);
    CHECK(tube.time() == 0);
    tube.advance_to(0);
    CHECK(tube.steps() == 0);
    tube.advance_to(0.00123);
    CHECK(tube.time() == 0.00123);
    tube.advance_to(blast.time);
    CHECK(tube.time() == blast.time);
    CHECK(tube.steps() > 140);  // 168
    CHECK(tube.steps() < 200);
    CHECK(tube.repeated_steps() > 0);  // 1
    CHECK(tube.cell_updates() == 100 * (tube.steps() + tube.repeated_steps()));
    CHECK_THROWS_WITH(tube.advance_to(0), Catch::Contains("time"));
    CHECK_THROWS_AS(tube.advance_to(std::nan("")), std::domain_error);
}
