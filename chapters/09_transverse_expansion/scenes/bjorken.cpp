#include "chapters/09_transverse_expansion/scenes/bjorken.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/09_transverse_expansion/curved_fluid.hpp"
#include "common/core/arrangement.hpp"

namespace sph::transverse {
namespace {

using Resolution = FixedH<AnyKernel<2>, OfCurvedEntropy>;
using BjorkenFluid = CurvedFluid<Resolution, ConformalFluid, BoostInvariant, Box<2>>;

/// The root T of T^(1/c2) sqrt(1 + (T0 u0/T)^2) tau = sqrt(1 + u0^2) tau0: the left side rises with T, since
/// its logarithm does for c2 < 1. By bisection.
double exact_bjorken_temperature(const BjorkenScene& scene, double tau) {
    double low = 1e-6, high = 1;
    const double wanted = std::sqrt(1 + square(scene.u)) * scene.tau0 / tau;
    for (int k = 0; k < 100; ++k) {
        const double T = std::sqrt(low * high);
        (std::pow(T, 1 / scene.c2) * std::sqrt(1 + square(scene.u / T)) < wanted ? low : high) = T;
    }
    return high;
}

}  // namespace

BjorkenRun run_bjorken(const BjorkenScene& scene) {
    constexpr double h_over_dx = 1.8;
    const Columns<2> x = make_points<2>(Arrangement::even, scene.per_side, 0, 1);
    const std::size_t n = x[0].size();
    BjorkenFluid fluid{
        n,
        Resolution{h_over_dx / static_cast<double>(scene.per_side), AnyKernel<2>{"wendland-c4"}},
        ConformalFluid{scene.c2},
        BoostInvariant{},
        Box<2>{{0, 0}, {1, 1}, Face::periodic},
        scene.threads};
    auto& p = fluid.particles;
    p.x = x;
    p.nu.assign(n, 1);
    fluid.resolve(scene.tau0);  // what the lattice makes of nu = 1; the momenta are 0 yet
    const double s_star = scene.tau0 * std::sqrt(1 + square(scene.u)), factor = s_star / p.s_star[0];
    for (std::size_t i = 0; i < n; ++i) p.nu[i] *= factor, p.s_star[i] = s_star, p.U[0][i] = scene.u;
    fluid.start(scene.tau0);
    fluid.integrate_by<RungeKutta4>();
    double tau = scene.tau0;
    BjorkenRun run;
    for (const double end : scene.times) {
        march(fluid, tau, {.end = end, .steps = 10});
        fluid.resolve(tau);
        const double T = exact_bjorken_temperature(scene, tau);
        double sum = 0, sum_u = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double found = std::pow(fluid.entropy(i, tau), scene.c2);
            run.error = std::max(run.error, std::abs(found / T - 1));
            sum += found, sum_u += p.U[0][i];
        }
        run.temperature.push_back(sum / static_cast<double>(n)),
            run.u.push_back(sum_u / static_cast<double>(n));
        run.exact_temperature.push_back(T), run.exact_u.push_back(scene.u / T);
    }
    return run;
}

}  // namespace sph::transverse
