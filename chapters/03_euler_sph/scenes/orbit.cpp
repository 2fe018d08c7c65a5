#include "chapters/03_euler_sph/scenes/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "common/core/march.hpp"
#include "common/core/motion.hpp"
#include "common/core/particles.hpp"

namespace sph::euler {
namespace {

using Body = Particles<2, Position, Velocity, Acceleration>;

Vector<2> place(const Body& p) {
    return {p.x[0][0], p.x[1][0]};
}
Vector<2> speed(const Body& p) {
    return {p.v[0][0], p.v[1][0]};
}
double energy(const Body& p) {
    return dot(speed(p), speed(p)) / 2 - 1 / std::sqrt(dot(place(p), place(p)));
}
double spin(const Body& p) {
    return p.x[0][0] * p.v[1][0] - p.x[1][0] * p.v[0][0];
}
/// The angle of the vector to the near end of the ellipse that belongs to the present state.
double axis(const Body& p) {
    const double L = spin(p), r = std::sqrt(dot(place(p), place(p)));
    return std::atan2(-p.v[0][0] * L - p.x[1][0] / r, p.v[1][0] * L - p.x[0][0] / r);
}

std::unique_ptr<Integrator> integrator_of(const std::string& name, const Motion& motion, const Rates& rates) {
    if (name == "leapfrog") return std::make_unique<KickDriftKick>(motion, rates);
    if (name == "RK4") return std::make_unique<RungeKutta4>(motion, rates);
    throw std::invalid_argument{"no such integrator: " + name};
}

}  // namespace

OrbitRun run_orbit(const OrbitScene& scene) {
    Body p{1};
    const double e = scene.eccentricity;
    p.x[0][0] = 1 + e;
    p.v[1][0] = std::sqrt((1 - e) / (1 + e));
    const auto rates = [&](double) {
        const double r2 = dot(place(p), place(p)), r3 = r2 * std::sqrt(r2);
        for (std::size_t a = 0; a < 2; ++a) p.dv_dt[a][0] = -p.x[a][0] / r3;
    };
    Motion motion;
    motion.evolve<Position, Velocity>(p).evolve<Velocity, Acceleration>(p).watch(p);
    const auto integrator = integrator_of(scene.integrator, motion, rates);
    const long per_period = scene.integrator == "RK4" ? scene.evaluations / 4 : scene.evaluations;
    const double E = energy(p), L = spin(p), start = axis(p);
    OrbitRun run;
    double t = 0;
    long k = 0;
    march(*integrator, t,
          {.end = 2 * std::numbers::pi * static_cast<double>(scene.periods),
           .steps = per_period * scene.periods},
          [&](double) {
              ++k;
              run.angular_momentum = std::max(run.angular_momentum, std::abs(spin(p) / L - 1));
              if (k > per_period * (scene.periods - 1)) {
                  run.x.push_back(p.x[0][0]);
                  run.y.push_back(p.x[1][0]);
              }
              if (k % per_period != 0) return;
              run.period.push_back(static_cast<double>(k / per_period));
              run.energy.push_back(energy(p) / E - 1);
          });
    run.turn = std::remainder(axis(p) - start, 2 * std::numbers::pi);
    run.miss = std::hypot(p.x[0][0] - (1 + e), p.x[1][0]);
    return run;
}

}  // namespace sph::euler
