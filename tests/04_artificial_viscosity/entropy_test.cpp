// What a dissipation does to the entropy of each particle, and a start without jumps.
#include <catch2/catch.hpp>
#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"

using namespace sph;
using namespace sph::shocks;

namespace {

/// The largest loss of entropy that any particle has between the first step and the last, and the largest
/// gain.
struct Change {
    double loss = 0, gain = 0;
};
Change change_of_entropy(const std::string& method, TubeScene scene) {
    Column first;
    Change change;
    const auto entropy = [&](const Simulation<1>& gas, std::size_t i) {
        return gas.get<Pressure>()[i] / std::pow(gas.get<Density>()[i], scene.gamma);
    };
    std::size_t last = 0;
    scene.watch = [&](double, const Simulation<1>& gas) {
        const std::size_t n = gas.get<Position>()[0].size();
        if (first.empty()) {
            for (std::size_t i = 0; i < n; ++i) first.push_back(entropy(gas, i));
        }
        change = {};
        for (std::size_t i = 0; i < n; ++i) {
            const double ratio = entropy(gas, i) / first[i] - 1;
            change.loss = std::max(change.loss, -ratio), change.gain = std::max(change.gain, ratio);
        }
        ++last;
    };
    run_tube(scene, tube_methods()[method]);
    REQUIRE(last > 50);
    return change;
}

}  // namespace

TEST_CASE("viscosity raises the entropy of every particle") {
    // (8.16). Fails if the heat of a pair has another sign or goes to one of the two only; conduction takes
    // entropy from the hot side of a contact.
    TubeScene scene;
    scene.n = 180, scene.courant = 0.1;
    const Change none = change_of_entropy("none", scene), viscous = change_of_entropy("alpha-beta", scene);
    CHECK(none.gain < 0.001);    // measured 1.1e-4: the time step's error
    CHECK(viscous.gain > 0.05);  // measured 0.14, at the contact; the shock's 0.055
    CHECK(viscous.loss < 1e-5);  // measured 2e-7
    CHECK(change_of_entropy("thermokinetic", scene).loss > 0.05);  // measured 0.10
}

TEST_CASE("thermokinetic conduction acts between particles that approach each other") {
    // Fails if it acts between all: where gas only expands nothing is conducted, and u is that of the
    // viscosity.
    TubeScene scene{{1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.05};
    scene.n = 60;
    const TubeRun viscous = run_tube(scene, tube_methods()["signal"]);
    CHECK(run_tube(scene, tube_methods()["thermokinetic"]).l1_u ==
          Approx(viscous.l1_u).epsilon(0.02));                                              // measured 0.005
    CHECK(run_tube(scene, tube_methods()["thermokinetic-all"]).l1_u > 1.3 * viscous.l1_u);  // 1.57
}

TEST_CASE("a smoothed start keeps the mass on each particle's left") {
    // Fails if the blend has another width or the density another sign: the spacings are m/rho of the blend.
    TubeScene scene;
    scene.n = 720;
    const std::array<double, 2> rho{1, 0.125};
    const TubeLattice sharp = lay_tube(scene, rho, {-0.5, 0.5});
    TubeLattice smooth = sharp;
    const double d = 0.02;
    smooth_positions(smooth, rho, d);
    CHECK(smooth.x.front() == Approx(sharp.x.front()).margin(1e-9));
    CHECK(smooth.x[smooth.free - 1] == Approx(sharp.x[smooth.free - 1]).margin(1e-9));
    for (std::size_t i = 1; i + 1 < smooth.free; i += 7) {
        const double share = right_share(smooth.x[i], d);
        const double expected = (1 - share) * rho[0] + share * rho[1];
        const double found = 2 * smooth.m[0] / (smooth.x[i + 1] - smooth.x[i - 1]);
        CHECK(found == Approx(expected).epsilon(0.02));
    }
    CHECK_THROWS_AS(smooth_positions(smooth, {1, 0}, d), std::invalid_argument);
    scene.smoothing = -1;
    CHECK_THROWS_AS(run_tube(scene, tube_methods()["signal"]), std::invalid_argument);
    scene.smoothing = d, scene.equal_masses = false;
    CHECK_THROWS_AS(run_tube(scene, tube_methods()["signal"]), std::invalid_argument);
}
