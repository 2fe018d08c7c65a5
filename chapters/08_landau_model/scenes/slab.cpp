#include "chapters/08_landau_model/scenes/slab.hpp"

#include <cmath>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/landau.hpp"

namespace sph::landau {
namespace {

SlabProfile profile_of(const Integrated<1>& fluid, double t) {
    const exact::LandauSlab solution{t};
    SlabProfile profile;
    profile.time = t;
    profile.x = fluid.get<Position>()[0];
    profile.s_star = fluid.get<EntropyDensity>();
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        const double U = fluid.get<FourVelocity>()[0][i];
        const auto exact = solution.at(profile.x[i]);
        profile.eps.push_back(ConformalFluid{}.energy(profile.s_star[i] / std::sqrt(1 + U * U)));
        profile.rapidity.push_back(std::asinh(U));
        profile.exact_s_star.push_back(exact.s_star);
        profile.exact_eps.push_back(exact.eps);
        profile.exact_rapidity.push_back(exact.rapidity);
    }
    profile.l1_s_star = slab_error(profile.x, profile.s_star, t);
    profile.edge_gap = solution.edge() - profile.x.back();
    return profile;
}

}  // namespace

Column slab_cells(std::size_t n, bool graded) {
    Column ends(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        const double xi = 2 * static_cast<double>(i) / static_cast<double>(n) - 1;
        ends[i] = graded ? std::sin(pi / 2 * xi) : xi;
    }
    return ends;
}

double slab_error(const Column& x, const Column& s_star, double t) {
    constexpr int points = 8000;
    const exact::LandauSlab solution{t};
    const double edge = solution.edge();
    double difference = 0, whole = 0;
    std::size_t j = 0;
    for (int k = 0; k < points; ++k) {
        const double at = edge * (2 * (k + 0.5) / points - 1), exact = solution.at(at).s_star;
        while (j + 2 < x.size() && x[j + 1] < at) ++j;
        const bool inside = at >= x.front() && at <= x.back();
        const double share = (at - x[j]) / (x[j + 1] - x[j]);
        const double value = inside ? s_star[j] + share * (s_star[j + 1] - s_star[j]) : 0;
        difference += std::abs(value - exact);
        whole += exact;
    }
    return difference / whole;
}

std::vector<SlabProfile> run_slab(const SlabScene& scene, const SlabMethod& method) {
    if (scene.n < 4) throw std::invalid_argument{"fewer than four particles"};
    if (!(scene.courant > 0)) throw std::invalid_argument{"courant must be above 0"};
    const auto fluid = method.make({slab_cells(scene.n, method.graded), scene.courant, scene.threads});
    double t = 0, seconds = 0;
    fluid->resolve(t);
    const double energy = fluid->totals().energy;
    std::vector<SlabProfile> profiles;
    for (const double end : scene.times) {
        seconds += march(*fluid, t, {.end = end, .progress = scene.progress}, [&](double now) {
                       require_order(fluid->get<Position>()[0], now);
                   }).seconds;
        fluid->resolve(t);
        const Totals<1> totals = fluid->totals();
        SlabProfile& profile = profiles.emplace_back(profile_of(*fluid, t));
        profile.energy_drift = totals.energy / energy - 1;
        profile.momentum = totals.momentum[0] / energy;
        profile.seconds = seconds;
        profile.counters = fluid->counters();
    }
    return profiles;
}

}  // namespace sph::landau
