#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/08_landau_model/baryon_state.hpp"
#include "common/exact/lorentz.hpp"

namespace sph::landau {
namespace {

using State = exact::Riemann::State;
constexpr double coldest = 1e-13;  // p/rho over lorentz^2: below it heat is lost beside the energy

double lorentz2(const State& state) {
    return 1 / ((1 - state.v) * (1 + state.v));
}

void require_relativistic_tube(const TubeScene& scene) {
    if (!(scene.gamma > 1 && scene.gamma <= 2)) throw std::invalid_argument{"gamma outside (1, 2]"};
    shocks::require_tube(scene);
    for (const State* state : {&scene.left, &scene.right}) {
        if (!(std::abs(state->v) < 1)) throw std::invalid_argument{"velocity outside (-1, 1)"};
        if (state->rho > 0 && state->p != 0 && !(state->p > coldest * lorentz2(*state) * state->rho))
            throw std::invalid_argument{
                "pressure is lost beside the energy; allowed: above 1e-13 rho/(1 - v^2), or 0"};
    }
}

}  // namespace

exact::RelativisticRiemann relativistic_solution(const TubeScene& scene) {
    const auto state = [](const State& s) { return exact::RelativisticRiemann::State{s.rho, s.v, s.p}; };
    return {state(scene.left), state(scene.right), scene.gamma};
}

shocks::TubeProblem relativistic_tube(const TubeScene& given) {
    require_relativistic_tube(given);
    const double lorentz = std::max(lorentz2(given.left), lorentz2(given.right));
    const TubeScene scene = shocks::with_heat(given, 2 * coldest * lorentz);
    constexpr double reserve = 1.02;  // of what a smeared wave runs ahead
    const auto solution = relativistic_solution(scene);
    const auto& waves = solution.waves();
    const auto density = [](const State& state) { return state.rho * std::sqrt(lorentz2(state)); };
    const auto energy = [&](const State& s) {
        return s.rho > 0 ? momentum_energy(s.rho, s.v, s.p, scene.gamma).E : 0;
    };
    return {IdealGas{scene.gamma},
            {scene.left, scene.right},
            {density(scene.left), density(scene.right)},
            {shocks::tube_end(scene, scene.left, -1, waves.left.head.v, reserve),
             shocks::tube_end(scene, scene.right, 1, waves.right.head.v, reserve)},
            {energy(scene.left), energy(scene.right)},
            exact_relativistic_tube(scene)};
}

shocks::ExactTube exact_relativistic_tube(const TubeScene& scene) {
    const auto sound_speed = [&](const State& s) {
        return s.rho > 0 ? std::sqrt(scene.gamma * s.p / (s.rho + scene.gamma / (scene.gamma - 1) * s.p)) : 0;
    };
    return shocks::exact_tube(relativistic_solution(scene), scene, sound_speed);
}

TubeRun run_relativistic_tube(const TubeScene& scene, const TubeMethod& method) {
    return shocks::run_tube(scene, method, relativistic_tube(scene));
}

std::optional<Shock> shock_of(const TubeRun& run, const TubeScene& scene, int side) {
    const auto solution = relativistic_solution(scene);
    const auto& [left, contact, right] = solution.waves();
    const auto &wave = side < 0 ? left : right, &other = side < 0 ? right : left;
    if (!wave.shock || solution.star().vacuum) return {};
    const double ahead = side < 0 ? scene.left.rho : scene.right.rho;
    const double behind = side < 0 ? solution.star().rho_left : solution.star().rho_right;
    const double level = 0.5 * (behind + ahead);
    const double inner = scene.diaphragm + 0.5 * (other.tail.v + contact.v) * scene.time;
    const auto& all = run.whole;
    std::optional<double> place;
    double peak = 0;
    for (std::size_t k = 1; k < all.x.size(); ++k) {  // outwards
        const std::size_t i = side < 0 ? all.x.size() - 1 - k : k, last = side < 0 ? i + 1 : i - 1;
        if (!(side * (all.x[i] - inner) > 0)) continue;
        const double before = all.rho[last] - level, after = all.rho[i] - level;
        if (before > 0 && after <= 0)
            place = all.x[last] + (all.x[i] - all.x[last]) * before / (before - after);
        peak = std::max(peak, all.rho[i] / behind);
    }
    if (!place) return {};
    const double way = wave.head.v * scene.time;
    const double least = (scene.window[1] - scene.window[0]) / 100;
    return Shock{*place, std::abs(*place - scene.diaphragm - way) / std::max(std::abs(way), least), peak};
}

std::optional<Shock> shock_of(const TubeRun& run, const TubeScene& scene) {
    const auto right = shock_of(run, scene, 1);
    return right ? right : shock_of(run, scene, -1);
}

shocks::TubeKind relativistic_kind() {
    const auto shocks_of = [](const TubeScene& scene, const TubeRun& run) {
        report::Quantities rows;
        const auto left = shock_of(run, scene, -1), right = shock_of(run, scene, 1);
        if (const auto& shock = right ? right : left)
            rows = {{"shock_position", shock->place}, {"shock_error", shock->error}};
        if (left && right) {
            rows.push_back({"left_shock_position", left->place});
            rows.push_back({"left_shock_error", left->error});
        }
        return rows;
    };
    TubeScene defaults = problem(1);
    defaults.n = 1000;
    return {relativistic_methods(),
            defaults,
            {1, 2, true},
            relativistic_tube,
            shocks_of,
            exact::relativistic::velocities(),
            {{"lorentz", exact::relativistic::lorentz_factor}}};
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
