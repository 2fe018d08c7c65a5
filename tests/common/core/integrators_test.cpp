#include "common/core/integrators.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace sph;

namespace {

using Motion = Equations<Evolve<Position, Velocity>, Evolve<Velocity, Acceleration>>;
using Points = Particles<1, Position, Velocity, Acceleration>;

/// Pendulums x'' = -sin x, started at rest at three angles.
struct Pendulums {
    Points points{3};
    Counters counters;
    double t = 0;
    Pendulums() { points.x[0] = {0.5, 1.0, 2.0}; }
    auto rates() {
        return [this](double) {
            for (std::size_t i = 0; i < 3; ++i) points.dv_dt[0][i] = -std::sin(points.x[0][i]);
        };
    }
    double energy() const {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += 0.5 * points.v[0][i] * points.v[0][i] - std::cos(points.x[0][i]);
        return sum;
    }
};

/// Damped, so that rates depend on velocities: x'' = -x - x'/2, x(0) = 1, x'(0) = 0.
struct Damped {
    Points points{1};
    Counters counters;
    double t = 0;
    Damped() { points.x[0][0] = 1; }
    auto rates() {
        return [this](double) { points.dv_dt[0][0] = -points.x[0][0] - 0.5 * points.v[0][0]; };
    }
    static double exact(double t) {
        const double w = std::sqrt(1 - 0.0625);
        return std::exp(-t / 4) * (std::cos(w * t) + std::sin(w * t) / (4 * w));
    }
};

template <class Integrator>
double damped_error(int steps) {
    Damped scene;
    Integrator integrator{scene.counters};
    for (int k = 0; k < steps; ++k) integrator.step(scene.points, scene.t, 3.0 / steps, scene.rates());
    CHECK(scene.counters.steps == steps);
    CHECK(scene.t == Approx(3));
    return std::abs(scene.points.x[0][0] - Damped::exact(3));
}
template <class Integrator>
double damped_order() {
    return std::log2(damped_error<Integrator>(200) / damped_error<Integrator>(400));
}

template <class Integrator>
double pendulum_x(int steps) {
    Pendulums scene;
    Integrator integrator{scene.counters};
    for (int k = 0; k < steps; ++k) integrator.step(scene.points, scene.t, 5.0 / steps, scene.rates());
    return scene.points.x[0][2];
}
template <class Integrator>
double pendulum_order() {
    const double fine = pendulum_x<RungeKutta4<Motion>>(20000);
    return std::log2((pendulum_x<Integrator>(200) - fine) / (pendulum_x<Integrator>(400) - fine));
}

}  // namespace

TEST_CASE("orders of the integrators") {
    // Measured orders in brackets. Fails for a wrong half step, weight or stage.
    CHECK(std::abs(pendulum_order<KickDriftKick<Motion>>() - 2) < 0.02);     // (2.000)
    CHECK(std::abs(pendulum_order<DriftKickDrift<Motion>>() - 2) < 0.02);    // (2.000)
    CHECK(std::abs(damped_order<PredictorCorrector<Motion>>() - 2) < 0.05);  // (2.01)
    CHECK(std::abs(damped_order<RungeKutta2<Motion>>() - 2) < 0.05);         // (2.00)
    CHECK(std::abs(damped_order<RungeKutta4<Motion>>() - 4) < 0.1);          // (4.00)
    CHECK(std::abs(pendulum_order<RungeKutta4<Motion>>() - 4) < 0.2);        // (3.88)
}

TEST_CASE("leapfrog returns where it came from, and keeps its energy") {
    // Fails for a kick and a drift that do not mirror each other. Runge-Kutta fails the same check.
    const auto there_and_back = [](auto integrator_of) {
        Pendulums scene;
        auto integrator = integrator_of(scene.counters);
        for (int k = 0; k < 1000; ++k) integrator.step(scene.points, scene.t, 0.05, scene.rates());
        for (double& v : scene.points.v[0]) v = -v;
        for (int k = 0; k < 1000; ++k) integrator.step(scene.points, scene.t, 0.05, scene.rates());
        return std::abs(scene.points.x[0][0] - 0.5) + std::abs(scene.points.x[0][2] - 2);
    };
    CHECK(there_and_back([](Counters& c) { return KickDriftKick<Motion>{c}; }) < 1e-11);   // measured: 1e-13
    CHECK(there_and_back([](Counters& c) { return DriftKickDrift<Motion>{c}; }) < 1e-11);  // measured: 1e-13
    CHECK(there_and_back([](Counters& c) { return RungeKutta2<Motion>{c}; }) > 1e-4);

    Pendulums scene;
    KickDriftKick<Motion> leapfrog{scene.counters};
    const double start = scene.energy();
    double worst = 0;
    for (int k = 0; k < 100000; ++k) {
        leapfrog.step(scene.points, scene.t, 0.05, scene.rates());
        worst = std::max(worst, std::abs(scene.energy() - start));
    }
    CHECK(worst < 2e-3);  // measured: oscillates within 6e-4 (dt^2), no drift
}

TEST_CASE("steps that vary and go back") {
    // The step follows the positions. With (5.47) as printed, without its factor 1/2, this does not return.
    for (const HalfSteps rule : {HalfSteps::arithmetic, HalfSteps::harmonic}) {
        Pendulums scene;
        ReversibleSteps<Motion> integrator{scene.counters, rule};
        const auto limit = [&] { return 0.02 * (2 + std::cos(scene.points.x[0][2])); };
        double dt = 0.02 * (2 + std::cos(2.0));
        double smallest = dt, largest = dt;
        for (int k = 0; k < 500; ++k) {
            integrator.step(scene.points, scene.t, dt, scene.rates(), limit);
            smallest = std::min(smallest, dt);
            largest = std::max(largest, dt);
        }
        CHECK(largest > 1.5 * smallest);
        for (double& v : scene.points.v[0]) v = -v;
        for (int k = 0; k < 500; ++k) integrator.step(scene.points, scene.t, dt, scene.rates(), limit);
        CHECK(std::abs(scene.points.x[0][0] - 0.5) < 1e-11);  // measured: 2e-14
        CHECK(std::abs(scene.points.x[0][2] - 2) < 1e-11);
        CHECK(std::abs(dt - 0.02 * (2 + std::cos(2.0))) < 1e-11);
    }
}

TEST_CASE("fixed particles stay, and what else they have evolves") {
    using Wet =
        Equations<Evolve<Position, Velocity>, Evolve<Velocity, Acceleration>, Evolve<Density, DensityRate>>;
    Particles<1, Position, Velocity, Acceleration, Density, DensityRate> particles{3};
    particles.v[0] = {1, 1, 1};
    particles.rho = {1, 1, 1};
    particles.fix_from(2);
    Counters counters;
    RungeKutta4<Wet> integrator{counters};
    double t = 0;
    integrator.step(particles, t, 0.5, [&](double) { particles.drho_dt = {2, 2, 2}; });
    CHECK(particles.x[0][0] == Approx(0.5));
    CHECK(particles.x[0][1] == Approx(0.5));
    CHECK(particles.x[0][2] == 0);
    for (const double rho : particles.rho) CHECK(rho == Approx(2));
    CHECK(particles.moving() == 2);
}

TEST_CASE("a state without meaning stops the run, naming time, particle and quantity") {
    using Wet = Equations<Evolve<Position, Velocity>, Evolve<Density, DensityRate>>;
    Particles<2, Position, Velocity, Density, DensityRate, ThermalEnergy> particles{3};
    Counters counters;
    RungeKutta2<Wet> integrator{counters};
    const auto reset = [&] {
        particles.rho.assign(3, 1);
        particles.drho_dt.assign(3, 0);
        particles.u.assign(3, 1);
        particles.v[1].assign(3, 0);
    };
    double t = 2;
    const auto message = [&](double dt) {
        try {
            integrator.step(particles, t, dt, [](double) {});
        } catch (const Unstable& error) {
            CHECK(error.code() == app::ExitCode::unphysical);
            return std::string{error.what()};
        }
        return std::string{};
    };
    reset();
    CHECK(message(0.5) == "");
    particles.drho_dt[1] = -3;
    CHECK(message(0.5) == "unphysical state at t = 3: density of particle 1 is -0.5");
    reset();
    particles.v[1][2] = std::numeric_limits<double>::quiet_NaN();
    CHECK(message(0.5) == "unphysical state at t = 3.5: position of particle 2 is nan");
    particles.x[1][2] = 0;
    reset();
    particles.u[0] = 0;  // not evolved here, but it has no meaning either
    CHECK(message(0.5) == "unphysical state at t = 4: thermal energy of particle 0 is 0");
    reset();
    CHECK(message(1e-20) == "unphysical state at t = 4: the time step is 1e-20");
    CHECK(message(std::numeric_limits<double>::infinity()) != "");
    Pendulums scene;
    ReversibleSteps<Motion> reversible{scene.counters};
    double dt = 0.1;
    CHECK_THROWS_AS(reversible.step(scene.points, scene.t, dt, scene.rates(), [] { return 0.5; }), Unstable);
}
