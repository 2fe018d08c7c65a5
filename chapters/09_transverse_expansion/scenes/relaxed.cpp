#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/03_euler_sph/gas.hpp"
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/core/arrangement.hpp"

namespace sph::transverse {
namespace {

/// Mirror images beyond the circle of radius R: what is as far outside as its particle is inside.
auto circle(double R) {
    const auto make = [R](const Columns<2>& x, double reach, std::vector<Ghost<2>>& ghosts) {
        for (std::size_t i = 0; i < x[0].size(); ++i) {
            const double r = std::hypot(x[0][i], x[1][i]);
            if (R - r > reach || !(r > 0)) continue;
            const double scale = (2 * R - r) / r;
            ghosts.push_back({static_cast<std::uint32_t>(i), {scale * x[0][i], scale * x[1][i]}, {1, 1}});
        }
    };
    const auto set = [](auto&, const auto&) {};
    return GhostsOf{make, set};
}

}  // namespace

Disc relaxed_disc(std::size_t n, double R, std::uint64_t seed, int threads) {
    using K = AnyKernel<2>;
    constexpr double h_over_dx = 1.7, friction = 3, courant = 0.5, time_in_crossings = 40;
    const double area = pi * R * R / static_cast<double>(n), spacing = std::sqrt(area);
    Disc disc;
    Uniform uniform{seed};
    while (disc.area.size() < n) {
        // Inside, so that no point lies on its own image.
        const double x = (2 * uniform() - 1) * R, y = (2 * uniform() - 1) * R;
        if (std::hypot(x, y) < R - 0.4 * spacing) disc.add(std::hypot(x, y), std::atan2(y, x), area);
    }
    const Quadratic state{0.5};  // c_s = 1 where rho = 1
    using Boundary = decltype(circle(R));
    Gas<ConsistentH<K>, Barotropic<Quadratic>, Boundary, Damping> gas{
        n,       ConsistentH<K>{HRule{h_over_dx}, 1e-4, K{"wendland-c4"}},
        {state}, circle(R),
        threads, Damping{friction / (h_over_dx * spacing)}};
    gas.particles.x = disc.x;
    gas.particles.m = disc.area;
    gas.particles.rho.assign(n, 1);
    gas.start(0);
    gas.integrate_by<RungeKutta2>();
    const double step = courant * spacing;
    gas.limit_steps([step] { return step; });
    double t = 0;
    march(gas, t, {.end = time_in_crossings * spacing});
    disc.x = gas.particles.x;
    return disc;
}

}  // namespace sph::transverse
