#pragma once
#include "common/core/particles.hpp"
#include "common/report/chapter.hpp"

/// Bjorken's flow that also moves transversally, all of it alike: a periodic square of side 1.
namespace sph::transverse {

struct BjorkenScene {
    std::size_t per_side = 16;
    double tau0 = 1, c2 = 1.0 / 3;
    double u = 0;               ///< u^x at tau0, where T = 1
    std::vector<double> times;  ///< increasing, > tau0
    int threads = 1;
};
struct BjorkenRun {
    Column temperature, u;              ///< means of the particles, at the times
    Column exact_temperature, exact_u;  ///< T u = T0 u0 and T^(1/c2) sqrt(1 + u^2) tau = const
    double error = 0;                   ///< largest relative one of T, of any particle at any of the times
};
BjorkenRun run_bjorken(const BjorkenScene& scene);

}  // namespace sph::transverse
