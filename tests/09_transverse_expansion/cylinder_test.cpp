// The cylinder and Gubser's flow on particles: errors, what is conserved, and where naive ways fail.
#include <catch2/catch.hpp>
#include <cmath>

#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/report/norms.hpp"

using namespace sph;
using namespace sph::transverse;

namespace {

Snapshot run(const Flow& flow, const std::string& method, std::size_t n, double tau) {
    return run_plane(flow, {.n = n, .times = {tau}}, plane_methods()[method]).back();
}
const Flow disc = cylinder(10, 1, 1.0 / 3);

}  // namespace

TEST_CASE("the recommended method follows the cylinder") {
    const Snapshot coarse = run(disc, "spiral-graded", 2500, 10),
                   fine = run(disc, "spiral-graded", 10000, 10);
    CHECK(coarse.l1_temperature < 0.014);  // measured 0.012
    // Measured 0.0040; with tau left out of P~ (mutation) 0.13 with 2500 particles.
    CHECK(fine.l1_temperature < 5e-3);
    CHECK(fine.l1_temperature > 1e-3);
    CHECK(fine.axis < 0.02);  // measured 0.007
    const double order =
        report::observed_order(50, coarse.l1_temperature, 100, fine.l1_temperature);  // in the spacing
    CHECK(order > 0.8);
    CHECK(order < 2.5);
}

TEST_CASE("entropy and momentum of the cylinder") {
    for (const char* method : {"spiral-graded", "grad-h", "hexagonal", "rings"}) {
        const Snapshot shot = run(disc, method, 2500, 5);
        INFO(method);
        CHECK(std::abs(shot.entropy) < 1e-12);  // measured 2e-13
        CHECK(shot.momentum < 1e-14);           // measured 2e-17
    }
    // Corrected gradients are no pair forces: measured 1e-6.
    CHECK(run(disc, "corrected", 2500, 5).momentum > 1e-9);
}

TEST_CASE("a fixed h loses the particles of the edge") {
    // Measured at tau = 15, N = 5000: 0.023 against 0.0074.
    const double fixed = run(disc, "fixed-h", 5000, 15).l1_temperature;
    CHECK(fixed > 2 * run(disc, "spiral-graded", 5000, 15).l1_temperature);
    // And it does not help to take more of them: measured 0.021 with half as many.
    CHECK(fixed > 0.8 * run(disc, "fixed-h", 2500, 15).l1_temperature);
}

TEST_CASE("Gubser's flow") {
    const Flow flow = gubser(1, 1);
    const Snapshot at = run(flow, "spiral-graded", 10000, 1.5);
    CHECK(at.l1_eps < 3e-3);  // measured 1.4e-3
    CHECK(at.l1_u < 1e-3);    // measured 7.7e-4
    // Half as large and half as late: the same flow in other units, but for the disc that is filled.
    const Flow half = gubser(2, 0.5);
    CHECK(run(half, "spiral-graded", 10000, 0.75).l1_eps < 4e-3);
}

TEST_CASE("steps of second and of fourth order") {
    const Flow flow = gubser(1, 1);
    const auto temperatures = [&](Order order, long steps) {
        return run_plane(flow, {.n = 500, .times = {1.5}, .order = order, .steps = steps},
                         plane_methods()["spiral-graded"])
            .back()
            .temperature;
    };
    const Column exact = temperatures(Order::fourth, 256);
    const auto error = [&](Order order, long steps) {
        const Column found = temperatures(order, steps);
        double most = 0;
        for (std::size_t i = 0; i < exact.size(); ++i)
            most = std::max(most, std::abs(found[i] / exact[i] - 1));
        return most;
    };
    // With rates at the beginning of the step alone (mutation) the first order is 1.
    const double second = report::observed_order(16, error(Order::second, 16), 32, error(Order::second, 32));
    CHECK(second > 1.8);
    CHECK(second < 2.6);
    CHECK(error(Order::fourth, 16) < error(Order::second, 16) / 5);
}

TEST_CASE("the same digits for one thread and for two") {
    const PlaneMethod& method = plane_methods().recommended();
    const auto one = run_plane(disc, {.n = 1500, .times = {2}, .threads = 1}, method).back(),
               two = run_plane(disc, {.n = 1500, .times = {2}, .threads = 2}, method).back();
    CHECK(one.temperature == two.temperature);
    CHECK(one.u_r == two.u_r);
}
