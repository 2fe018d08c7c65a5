#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/scenes/quadratic.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "chapters/08_landau_model/relativistic_gas.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

using State = exact::Riemann::State;

double lab_density(const State& state) {
    return state.rho / std::sqrt((1 - state.v) * (1 + state.v));
}

void require_sound(const TubeScene& scene) {
    constexpr double coldest = 1e-13;
    if (!(scene.gamma > 1 && scene.gamma <= 2)) throw std::invalid_argument{"gamma outside (1, 2]"};
    if (!(scene.jitter >= 0 && scene.jitter < 0.5)) throw std::invalid_argument{"jitter outside 0..0.5"};
    if (!(scene.time > 0)) throw std::invalid_argument{"time must be above 0"};
    for (const State* state : {&scene.left, &scene.right}) {
        if (!(std::abs(state->v) < 1)) throw std::invalid_argument{"velocity outside (-1, 1)"};
        const double lorentz2 = 1 / ((1 - state->v) * (1 + state->v));
        if (state->rho > 0 && !(state->p > coldest * lorentz2 * state->rho))
            throw std::invalid_argument{
                "pressure is lost beside the energy; allowed: above 1e-13 rho/(1 - v^2)"};
    }
}

/// Where the gas of either side begins at t = 0, so that no wave reaches an end and |x| < 0.5 is filled.
std::array<double, 2> ends(const TubeScene& scene, const exact::RelativisticRiemann& solution) {
    constexpr double reserve = 1.02;  // of what a smeared wave runs ahead
    const auto& waves = solution.waves();
    const auto reach = [&](const State& state, double side, double head) {
        if (state.rho == 0) return 0.0;
        const double run = scene.time * side * state.v;
        return side * std::max({0.5, 0.5 - run, reserve * (scene.time * side * head - run)});
    };
    return {reach(scene.left, -1, waves.left.head.v), reach(scene.right, 1, waves.right.head.v)};
}

template <class Gas>
void fill(Gas& gas, const TubeScene& scene, const TubeLattice& lattice, const HRule& rule) {
    const std::array sides{scene.left, scene.right};
    auto& p = gas.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const State& state = sides[lattice.side[i]];
        const MomentumEnergy given = momentum_energy(state.rho, state.v, state.p, scene.gamma);
        p.x[0][i] = lattice.x[i], p.m[i] = lattice.m, p.rho[i] = lab_density(state);
        p.q[0][i] = given.q, p.E[i] = given.E, p.p[i] = state.p;
        p.h[i] = rule.h(p.m[i], p.rho[i], 1);
    }
    p.fix_from(lattice.moving);
}

template <class Kernel, class Scheme>
RelativisticTubeRun run(const TubeScene& scene, const Method& method) {
    const auto solution = relativistic_solution(scene);
    const TubeLattice lattice = lay_tube({lab_density(scene.left), lab_density(scene.right)},
                                         ends(scene, solution), scene.n, scene.jitter, scene.seed);
    const HRule rule{method.h_over_dx};
    RelativisticGas<Kernel, Scheme> gas{lattice.x.size(), rule, scene.gamma, scene.threads};
    fill(gas, scene, lattice, rule);
    const auto& p = gas.particles;
    gas.resolve(0);
    const double energy = gas.energy(), momentum = gas.momentum();
    double scale = 0, t = 0;
    for (std::size_t i = 0; i < p.moving(); ++i) scale += p.m[i] * p.E[i];
    const double begin = report::thread_cpu_seconds();
    gas.advance(t, scene.time, scene.courant, [&](double now) {
        require_order(p.x[0], p.moving(), now);
        if (gas.counters().steps >= scene.most_steps)
            throw Unstable{now, Unstable::no_particle, "the number of steps",
                           static_cast<double>(scene.most_steps)};
    });
    RelativisticTubeRun result;
    result.seconds = report::thread_cpu_seconds() - begin;
    result.energy_drift = std::abs(gas.energy() / energy - 1);
    result.momentum_drift = std::abs(gas.momentum() - momentum) / scale;
    result.counters = gas.counters();
    Profile all;
    for (std::size_t i = 0; i < p.moving(); ++i) {
        const double lorentz = std::cosh(p.y[i]);
        all.x.push_back(p.x[0][i]), all.rho.push_back(p.rho[i] / lorentz), all.v.push_back(p.v[0][i]);
        all.p.push_back(p.p[i]), all.u.push_back(p.u[i]);
    }
    look_at_shock(result, all, scene, solution);
    const Column dx = spacings(all.x);
    result.profile = std::move(all);
    compare(result, dx, exact_tube(solution, scene.time));
    return result;
}

}  // namespace

void look_at_shock(RelativisticTubeRun& run, const Profile& all, const TubeScene& scene,
                   const exact::RelativisticRiemann& solution) {
    const auto& waves = solution.waves();
    if (!waves.right.shock || solution.star().vacuum) return;
    const double behind = solution.star().rho_right, level = 0.5 * (behind + scene.right.rho);
    for (std::size_t i = 1; i < all.x.size(); ++i) {
        const double before = all.rho[i - 1] - level, after = all.rho[i] - level;
        const bool of_right_wave = all.x[i] > 0.5 * (waves.left.tail.v + waves.contact.v) * scene.time;
        if (of_right_wave && before > 0 && after <= 0)
            run.shock = all.x[i - 1] + (all.x[i] - all.x[i - 1]) * before / (before - after);
        if (of_right_wave) run.shell_peak = std::max(run.shell_peak, all.rho[i] / behind);
    }
    run.shock_error = std::abs(run.shock / (waves.right.head.v * scene.time) - 1);
}

const std::vector<Method>& relativistic_methods() {
    static const std::vector<Method> methods{{"none", "no dissipation", "cubic", 1.2},
                                             {"chow-monaghan", "Chow–Monaghan", "cubic", 1.2},
                                             {"reconstructed", "reconstructed", "quadratic", 1.0}};
    return methods;
}

const Method& relativistic_method(const std::string& name) {
    for (const Method& method : relativistic_methods()) {
        if (method.name == name) return method;
    }
    throw std::invalid_argument{"no such method: " + name};
}

exact::RelativisticRiemann relativistic_solution(const TubeScene& scene) {
    const auto state = [](const State& s) { return exact::RelativisticRiemann::State{s.rho, s.v, s.p}; };
    return {state(scene.left), state(scene.right), scene.gamma};
}

RelativisticTubeRun run_relativistic_tube(const TubeScene& scene, const Method& method) {
    require_sound(scene);
    if (method.name == "none") return run<CubicSpline<1>, NoScheme>(scene, method);
    if (method.name == "chow-monaghan") return run<CubicSpline<1>, ChowMonaghanScheme>(scene, method);
    return run<QuadraticSpline<1>, ReconstructedScheme>(scene, relativistic_method(method.name));
}

}  // namespace sph
