// What evolves: drifts and kicks, held particles, copies, threads.
#include "common/core/motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "common/core/integrators.hpp"

using namespace sph;

namespace {

using Wet = Particles<2, Position, Velocity, Acceleration, Density, DensityRate>;

void evolve_all(Motion& motion, Wet& particles) {
    motion.evolve<Position, Velocity>(particles)
        .evolve<Velocity, Acceleration>(particles)
        .evolve<Density, DensityRate>(particles);
}

Wet particles_at_rest(std::size_t n) {
    Wet particles{n};
    particles.rho.assign(n, 1);
    return particles;
}

}  // namespace

TEST_CASE("an equation whose rate is itself a value is a drift, whatever the order of declaration") {
    // Fails if v's kick is taken for a drift, or if x drifts with a velocity that belongs to another time.
    for (const bool position_first : {true, false}) {
        Wet particles = particles_at_rest(1);
        Motion motion;
        if (position_first) {
            motion.evolve<Position, Velocity>(particles).evolve<Velocity, Acceleration>(particles);
        } else {
            motion.evolve<Velocity, Acceleration>(particles).evolve<Position, Velocity>(particles);
        }
        particles.v[0] = {3};
        particles.dv_dt[0] = {5};
        motion.drift(0.5);
        CHECK(particles.x[0][0] == 1.5);
        CHECK(particles.v[0][0] == 3);
        motion.kick(0.5);
        CHECK(particles.x[0][0] == 1.5);
        CHECK(particles.v[0][0] == 5.5);
        Motion::Saved saved;
        saved.save(motion);
        saved.advance(motion, 2);  // x by the velocity that was saved, not by the one that is kicked
        CHECK(particles.x[0][0] == 1.5 + 2 * 5.5);
        CHECK(particles.v[0][0] == 5.5 + 2 * 5);
        saved.restore(motion);
        CHECK(particles.x[0][0] == 1.5);
        CHECK(particles.v[0][0] == 5.5);
        saved.add(motion, 1);
        saved.restore(motion);
        CHECK(particles.x[0][0] == 7);
        CHECK(particles.v[0][0] == 10.5);
    }
}

TEST_CASE("held particles keep their velocity and drift with it; what else they have evolves") {
    // Fails if held particles are kicked, if they do not drift (a wall that moves), or if their density
    // stays.
    const auto check = []<class I>(std::type_identity<I>) {
        Wet particles = particles_at_rest(5);
        particles.v[0] = {1, 1, 1, 0, 2};
        particles.groups.hold("wall", 3, 4);    // at rest
        particles.groups.hold("piston", 4, 5);  // moving on
        Motion motion;
        evolve_all(motion, particles);
        I integrator{motion, [&](double) {
                         particles.dv_dt[0] = {4, 4, 4, 4, 4};
                         particles.drho_dt = {2, 2, 2, 2, 2};
                     }};
        double t = 0;
        integrator.step(t, 0.5);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(particles.v[0][i] == Approx(3));
            CHECK(particles.x[0][i] == Approx(1));  // 0.5 + 4 * 0.5^2/2
        }
        CHECK(particles.v[0][3] == 0);
        CHECK(particles.x[0][3] == 0);
        CHECK(particles.v[0][4] == 2);
        CHECK(particles.x[0][4] == Approx(1));
        for (const double rho : particles.rho) CHECK(rho == Approx(2));
    };
    check(std::type_identity<KickDriftKick>{});
    check(std::type_identity<DriftKickDrift>{});
    check(std::type_identity<PredictorCorrector>{});
    check(std::type_identity<RungeKutta2>{});
    check(std::type_identity<RungeKutta4>{});
}

TEST_CASE("motion is bitwise the same on one thread and on two") {
    // Fails if a part of the particles is left out or moved twice; groups cut the parts.
    constexpr std::size_t n = 100000;  // several parts that are worth a thread
    const auto moved = [](int threads) {
        app::Team team{threads};
        Wet particles = particles_at_rest(n);
        for (std::size_t i = 0; i < n; ++i) {
            particles.v[0][i] = std::sin(0.1 * static_cast<double>(i));
            particles.v[1][i] = std::cos(0.3 * static_cast<double>(i));
        }
        particles.groups.hold("wall", 1000, 1010);
        particles.groups.hold("end", n - 7, n);
        Motion motion{team};
        evolve_all(motion, particles);
        RungeKutta4 integrator{motion, [&](double t) {
                                   for (std::size_t i = 0; i < n; ++i) {
                                       particles.dv_dt[0][i] = t - particles.x[0][i];
                                       particles.dv_dt[1][i] = -particles.v[0][i];
                                       particles.drho_dt[i] = 0.1 * particles.v[1][i];
                                   }
                               }};
        double t = 0;
        for (int k = 0; k < 3; ++k) integrator.step(t, 0.1);
        return particles;
    };
    const Wet one = moved(1), two = moved(2);
    CHECK(two.x == one.x);
    CHECK(two.v == one.v);
    CHECK(two.rho == one.rho);
    CHECK(one.v[0][1003] == std::sin(0.1 * 1003));  // held
    CHECK(one.v[0][999] != std::sin(0.1 * 999));
}

TEST_CASE("only what evolves or is watched is looked at") {
    // Fails if watch() is what evolve() does, or if a column that may be negative is refused.
    Particles<1, Position, Velocity, Pressure, ThermalEnergy> particles{2};
    particles.p = {-1, -2};
    particles.u = {1, 0};
    Motion unwatched, watched;
    unwatched.evolve<Position, Velocity>(particles);
    watched.evolve<Position, Velocity>(particles).watch(particles);
    CHECK_NOTHROW(unwatched.require_physical(0));
    CHECK_THROWS_WITH(watched.require_physical(0.5),
                      "unphysical state at t = 0.5: thermal energy of particle 1 is 0");
    particles.u = {1, 1};
    CHECK_NOTHROW(watched.require_physical(0));
    particles.x[0][1] = std::nan("");
    CHECK_THROWS_WITH(unwatched.require_physical(0), Catch::Contains("position of particle 1 is nan"));
}
