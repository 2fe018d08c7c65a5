#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/08_landau_model/baryon_state.hpp"

namespace sph::landau {
namespace {

using State = exact::Riemann::State;

double lorentz2(const State& state) {
    return 1 / ((1 - state.v) * (1 + state.v));
}

void require_relativistic_tube(const TubeScene& scene) {
    constexpr double coldest = 1e-13;
    if (!(scene.gamma > 1 && scene.gamma <= 2)) throw std::invalid_argument{"gamma outside (1, 2]"};
    shocks::require_tube(scene);
    for (const State* state : {&scene.left, &scene.right}) {
        if (!(std::abs(state->v) < 1)) throw std::invalid_argument{"velocity outside (-1, 1)"};
        if (state->rho > 0 && !(state->p > coldest * lorentz2(*state) * state->rho))
            throw std::invalid_argument{
                "pressure is lost beside the energy; allowed: above 1e-13 rho/(1 - v^2)"};
    }
}

}  // namespace

exact::RelativisticRiemann relativistic_solution(const TubeScene& scene) {
    const auto state = [](const State& s) { return exact::RelativisticRiemann::State{s.rho, s.v, s.p}; };
    return {state(scene.left), state(scene.right), scene.gamma};
}

shocks::TubeProblem relativistic_tube(const TubeScene& scene) {
    require_relativistic_tube(scene);
    constexpr double reserve = 1.02;  // of what a smeared wave runs ahead
    const auto solution = relativistic_solution(scene);
    const auto& waves = solution.waves();
    const auto density = [](const State& state) { return state.rho * std::sqrt(lorentz2(state)); };
    const auto energy = [&](const State& s) {
        return s.rho > 0 ? momentum_energy(s.rho, s.v, s.p, scene.gamma).E : 0;
    };
    return {IdealGas{scene.gamma},
            {density(scene.left), density(scene.right)},
            {shocks::tube_end(scene, scene.left, -1, waves.left.head.v, reserve),
             shocks::tube_end(scene, scene.right, 1, waves.right.head.v, reserve)},
            {energy(scene.left), energy(scene.right)},
            shocks::exact_tube(solution, scene.time)};
}

TubeRun run_relativistic_tube(const TubeScene& scene, const TubeMethod& method) {
    return shocks::run_tube(scene, method, relativistic_tube(scene));
}

Shock shock_of(const TubeRun& run, const TubeScene& scene) {
    const auto solution = relativistic_solution(scene);
    const auto& waves = solution.waves();
    const auto& all = run.whole;
    Shock shock;
    if (!waves.right.shock || solution.star().vacuum) return shock;
    const double behind = solution.star().rho_right, level = 0.5 * (behind + scene.right.rho);
    for (std::size_t i = 1; i < all.x.size(); ++i) {
        const double before = all.rho[i - 1] - level, after = all.rho[i] - level;
        const bool of_right_wave = all.x[i] > 0.5 * (waves.left.tail.v + waves.contact.v) * scene.time;
        if (of_right_wave && before > 0 && after <= 0)
            shock.place = all.x[i - 1] + (all.x[i] - all.x[i - 1]) * before / (before - after);
        if (of_right_wave) shock.peak = std::max(shock.peak, all.rho[i] / behind);
    }
    shock.error = std::abs(shock.place / (waves.right.head.v * scene.time) - 1);
    return shock;
}

shocks::TubeKind relativistic_kind() {
    const auto shock = [](const TubeScene& scene, const TubeRun& run) {
        const Shock found = shock_of(run, scene);
        return report::Quantities{{"shock_position", found.place}, {"shock_error", found.error}};
    };
    TubeScene defaults = problem(1);
    defaults.n = 1000;
    return {relativistic_methods(), defaults, {1, 2, true}, relativistic_tube, shock};
}

TubeScene problem(int which) {
    if (which == 1) return {{10, 0, 13.33}, {1, 0, 1e-8}, 5.0 / 3, 0.4};
    return {{1, 0, 1000}, {1, 0, 0.01}, 5.0 / 3, 0.35};
}
TubeScene streams(double lorentz, double p, double gamma) {
    const double v = std::sqrt(1 - 1 / (lorentz * lorentz));
    return {{1, v, p}, {1, -v, p}, gamma, 0.3};
}

}  // namespace sph::landau
