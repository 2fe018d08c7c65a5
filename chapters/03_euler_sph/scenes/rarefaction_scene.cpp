#include "chapters/03_euler_sph/scenes/rarefaction_scene.hpp"

#include "common/exact/rarefaction.hpp"

namespace sph {
namespace {

template <class Resolution>
using HotGas = Gas<Resolution, Thermal>;

/// Spacing of particle i: half the distance of its neighbours, all of it at an end.
double spacing(const Column& x, std::size_t i) {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, x.size() - 1);
    return (x[high] - x[low]) / static_cast<double>(high - low);
}

template <class Resolution>
HotGas<Resolution> hot_gas(const RarefactionScene& scene, const Resolution& resolution) {
    HotGas<Resolution> gas{scene.n, resolution, {{scene.gamma}}, Free{}, scene.threads};
    auto& p = gas.particles;
    const auto place = [&](double share) {
        const double s = 2 * share - 1;
        return 0.5 * (scene.graded ? 0.2 * s + 0.8 * std::sin(std::numbers::pi / 2 * s) : s);
    };
    const auto n = static_cast<double>(scene.n);
    for (std::size_t i = 0; i < scene.n; ++i) {
        const auto k = static_cast<double>(i);
        p.x[0][i] = place((k + 0.5) / n);
        p.m[i] = place((k + 1) / n) - place(k / n);
        p.rho[i] = 1;
        p.u[i] = scene.u;
        if constexpr (requires { p.h[i]; }) p.h[i] = resolution.rule.sigma * p.m[i];
    }
    return gas;
}

/// The step that sound crossing the least spacing allows. Throws Unstable when particles have crossed.
template <class G>
double time_step(const G& gas, double courant, double t) {
    const auto& p = gas.particles;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        const double gap = p.x[0][i + 1] - p.x[0][i];
        if (!(gap > 0)) throw Unstable{t, i, "the distance to the next particle", gap};
        const double c_s = std::max(gas.matter().sound_speed(p, i), gas.matter().sound_speed(p, i + 1));
        least = std::min(least, gap / c_s);
    }
    return courant * least;
}

template <class Resolution>
RarefactionRun run(const RarefactionScene& scene, const Resolution& resolution) {
    auto gas = hot_gas(scene, resolution);
    auto& p = gas.particles;
    gas.resolve(0);
    const double start = gas.energy();
    RungeKutta4<typename HotGas<Resolution>::Motion> integrator{gas.counters()};
    const auto rates = [&](double now) { gas.rates(now); };
    double t = 0;
    while (t < scene.time) {
        const double dt = time_step(gas, scene.courant, t), left = scene.time - t;
        integrator.step(p, t, left < 1.5 * dt ? left : dt, rates);
    }
    gas.resolve(t);
    const exact::Rarefaction exact{1, scene.u, scene.gamma, 0.5};
    RarefactionRun result;
    double v_error = 0, v_size = 0, rho_error = 0, rho_size = 0;
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double dx = spacing(p.x[0], i);
        const auto e = exact.at(p.x[0][i], scene.time);
        result.exact_v.push_back(e.v);
        result.exact_rho.push_back(e.rho);
        v_error += dx * std::abs(p.v[0][i] - e.v);
        v_size += dx * std::abs(e.v);
        rho_error += dx * std::abs(p.rho[i] - e.rho);
        rho_size += dx * e.rho;
    }
    result.velocity_error = v_error / v_size;
    result.density_error = rho_error / rho_size;
    result.energy_drift = gas.energy() / start - 1;
    result.momentum = gas.momentum()[0] / exact.sound_speed();
    result.edge = p.x[0].back();
    result.front = exact.front(scene.time);
    result.counters = gas.counters();
    result.x = p.x[0];
    result.v = p.v[0];
    result.rho = p.rho;
    return result;
}

}  // namespace

RarefactionRun run_rarefaction(const RarefactionScene& scene, const GasScheme& scheme) {
    return with_scheme(scheme, 1.0 / static_cast<double>(scene.n),
                       [&](const auto& resolution) { return run(scene, resolution); });
}

}  // namespace sph
