#pragma once
#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "common/core/integrators.hpp"
#include "common/core/march.hpp"

// The scene that common/core/README.md shows; a test keeps the two the same and runs it.
namespace example {

// [effects]
/// dv_i/dt = - sum_j m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij   (Monaghan 2005, 3.8)
struct PressureForce {
    using Reads = sph::List<sph::Density, sph::Pressure>;  // of both particles
    using ReadsJ = sph::List<sph::Mass>;                   // of the neighbour j only
    using Adds = sph::List<sph::Acceleration>;             // what is summed
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * (i.p / (i.rho * i.rho) + j.p / (j.rho * j.rho)) * pair.F) * pair.x_ij;
    }
};

/// dv_i/dt = - Omega^2 x_i, a force without pairs.
struct Spring {
    double Omega2;
    using ReadsI = sph::List<sph::Position>;
    using Writes = sph::List<sph::Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= Omega2 * i.x; }
};
// [end]

// [scene]
using namespace sph;
using Drop = Particles<2, Position, Velocity, Acceleration, Mass, Density, Pressure>;

/// A drop of gas, p = rho^2, held together by a spring, in free space: so many equal leapfrog steps to t =
/// end.
inline Counters run(Drop& drop, double h, double end, long steps, int threads) {
    Neighbours<2> neighbours{Free{}, threads};
    const ConstantH<CubicSpline<2>> smoothing{h};
    Motion motion{neighbours.team()};
    motion.evolve<Position, Velocity>(drop).evolve<Velocity, Acceleration>(drop);
    const auto rates = [&](double /*t*/) {
        neighbours.find(drop.x, smoothing.reach());
        sum_over_neighbours(drop, neighbours, smoothing, Effects{SummedDensity{}});
        for (std::size_t i = 0; i < drop.size(); ++i) drop.p[i] = drop.rho[i] * drop.rho[i];
        sum_over_neighbours(drop, neighbours, smoothing, Effects{PressureForce{}, Spring{.Omega2 = 1}});
    };
    KickDriftKick leapfrog{motion, rates};
    double t = 0;
    const Marched done = march(leapfrog, t, {.end = end, .steps = steps});
    neighbours.counters().steps += done.steps;
    return neighbours.counters();
}
// [end]

}  // namespace example
