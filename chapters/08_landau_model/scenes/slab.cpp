#include "chapters/08_landau_model/scenes/slab.hpp"

#include <memory>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/scenes/quadratic.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "common/exact/landau.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

/// Sets particle i at rest: place, entropy, h to begin the search with.
template <class P>
void set(P& p, std::size_t i, double x, double nu, double h) {
    p.x[0][i] = x, p.m[i] = nu, p.rho[i] = 1;
    if constexpr (Has<P, SmoothingLength>) p.h[i] = h;
}

template <class Fluid>
SlabProfile profile_of(const Fluid& fluid, double t) {
    const auto& p = fluid.particles;
    const exact::LandauSlab solution{t};
    SlabProfile profile;
    profile.time = t, profile.x = p.x[0], profile.s_star = p.rho;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto exact = solution.at(p.x[0][i]);
        profile.eps.push_back(ConformalFluid{}.energy(p.rho[i] / fluid.lorentz(i)));
        profile.rapidity.push_back(std::asinh(p.u[0][i]));
        profile.exact_s_star.push_back(exact.s_star);
        profile.exact_eps.push_back(exact.eps);
        profile.exact_rapidity.push_back(exact.rapidity);
    }
    profile.l1_s_star = slab_error(profile.x, profile.s_star, t);
    profile.edge_gap = solution.edge() - profile.x.back();
    return profile;
}

/// Steps that grow by a tenth from a small first one: the particles at the edge start from rest, and what RK4
/// misses of their start it misses for good.
template <class Resolution>
std::vector<SlabProfile> run(const SlabScene& scene, const SlabMethod& method, Resolution resolution) {
    using Fluid = EntropicFluid<Resolution, ConformalFluid>;
    constexpr double first_step = 0.05, growth = 1.1;
    const Column cells = slab_cells(scene.n, method.graded);
    Fluid fluid{scene.n, std::move(resolution), ConformalFluid{}, scene.threads};
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double nu = cells[i + 1] - cells[i];
        set(fluid.particles, i, 0.5 * (cells[i] + cells[i + 1]), nu, method.h * nu);
    }
    double seconds = 0, begin = report::thread_cpu_seconds(), t = 0;
    fluid.resolve(t);
    const double energy = fluid.energy();
    RungeKutta4<typename Fluid::Motion> integrator{fluid.counters()};
    double longest = first_step * scene.courant * fluid.crossing_time();
    std::vector<SlabProfile> profiles;
    for (const double end : scene.times) {
        while (t < end) {
            const double allowed = std::min(scene.courant * fluid.crossing_time(), longest);
            const double left = end - t;
            const double dt = left > 2 * allowed ? allowed : left > allowed ? left / 2 : left;
            longest = growth * allowed;
            integrator.step(fluid.particles, t, dt, [&](double now) { fluid.rates(now); });
            if (dt == left) t = end;
            require_order(fluid.particles.x[0], scene.n, t);
        }
        fluid.resolve(t);
        seconds += report::thread_cpu_seconds() - begin;
        profiles.push_back(profile_of(fluid, t));
        SlabProfile& profile = profiles.back();
        profile.energy_drift = fluid.energy() / energy - 1;
        profile.momentum = fluid.momentum() / energy;
        profile.seconds = seconds, profile.counters = fluid.counters();
        begin = report::thread_cpu_seconds();
    }
    return profiles;
}

template <template <int> class Kernel>
std::vector<SlabProfile> run_with(const SlabScene& scene, const SlabMethod& method) {
    using K = Kernel<1>;
    constexpr double close = 1e-7;  // leaves 1e-14: the energy hangs on h
    if (!method.varies) return run(scene, method, FixedH<K>{method.h * 2 / static_cast<double>(scene.n)});
    if (!method.with_omega) return run(scene, method, WithoutOmega<K>{HRule{method.h}});
    return run(scene, method, ConsistentH<K>{HRule{method.h}, close});
}

}  // namespace

const std::vector<SlabMethod>& slab_methods() {
    static const std::vector<SlabMethod> methods{
        {"fixed-4", "fixed $h$ = 4", "cubic", 4, false},
        {"fixed-10", "fixed $h$ = 10", "cubic", 10, false},
        {"fixed-20", "fixed $h$ = 20", "cubic", 20, false},
        {"variable", "$h$ = 2 ν/$s$*", "cubic", 2},
        {"without-omega", "$h$ = 2 ν/$s$*, no grad-h terms", "cubic", 2, true, false, false},
        {"graded", "$h$ = 2 ν/$s$*, graded", "cubic", 2, true, true},
        {"narrow", "quadratic, $h$ = ν/$s$*", "quadratic", 1},
        {"narrow-graded", "quadratic, $h$ = ν/$s$*, graded", "quadratic", 1, true, true}};
    return methods;
}

const SlabMethod& slab_method(const std::string& name) {
    for (const SlabMethod& method : slab_methods()) {
        if (method.name == name) return method;
    }
    throw std::invalid_argument{"no such method: " + name};
}

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
    return method.kernel == "cubic" ? run_with<CubicSpline>(scene, method)
                                    : run_with<QuadraticSpline>(scene, method);
}

}  // namespace sph
