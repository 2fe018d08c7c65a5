#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "common/core/unstable.hpp"
#include "common/report/norms.hpp"

namespace sph::shocks {
namespace {

using State = exact::Riemann::State;

/// Between both states, at x from the diaphragm.
State smoothed(const std::array<State, 2>& sides, double x, double d) {
    const double share = right_share(x, d);
    const auto mean = [&](double left, double right) { return (1 - share) * left + share * right; };
    const auto& [left, right] = sides;
    const double rho = mean(left.rho, right.rho);
    return {rho, mean(left.v, right.v), rho * mean(left.p / left.rho, right.p / right.rho)};
}

std::unique_ptr<Simulation<1>> fill(const TubeScene& scene, const Method<1>& method,
                                    const TubeProblem& problem, const TubeLattice& lattice) {
    auto gas = method.make({.n = lattice.x.size(),
                            .state = problem.state,
                            .box = Box<1>{{-1}, {1}, Face::free},
                            .courant = scene.courant,
                            .threads = scene.threads});
    for (std::size_t i = 0; i < lattice.x.size(); ++i) {
        const State state = scene.smoothing > 0 ? smoothed(problem.sides, lattice.x[i], scene.smoothing)
                                                : problem.sides[lattice.side[i]];
        gas->place(i, {scene.diaphragm + lattice.x[i]}, {state.v}, lattice.m[lattice.side[i]], state.rho,
                   state.p);
    }
    for (const Group& layer : lattice.layers) gas->groups().hold(layer.name, layer.begin, layer.end);
    gas->start(0);
    gas->resolve(0);
    return gas;
}

/// sum m (|v| + c_s) at the start.
double momentum_scale(const TubeProblem& problem, const TubeLattice& lattice) {
    double scale = 0;
    for (const std::size_t side : lattice.side) scale += lattice.m[side] * problem.momentum[side];
    return scale;
}

/// The first n particles: those that are free.
Profile profile_of(const Simulation<1>& gas, std::size_t n) {
    const auto part = [n](const Column& c) {
        return Column(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(n));
    };
    return {part(gas.get<Position>()[0]), part(gas.get<Density>()), part(gas.get<Velocity>()[0]),
            part(gas.get<Pressure>()), part(gas.get<ThermalEnergy>())};
}

void append(Profile& profile, double x, const exact::Riemann::Point& at) {
    profile.x.push_back(x);
    profile.rho.push_back(at.rho);
    profile.v.push_back(at.v);
    profile.p.push_back(at.p);
    profile.u.push_back(at.u);
}

/// L1 of value - exact over that of exact, or over `scale` where there is less than a thousandth of it.
double relative_l1(const Column& value, const Column& exact, const Column& dx, double scale) {
    constexpr double nothing = 1e-3;
    double missed = 0, field = 0, length = 0;
    for (std::size_t i = 0; i < dx.size(); ++i) {
        missed += std::abs(value[i] - exact[i]) * dx[i];
        field += std::abs(exact[i]) * dx[i], length += dx[i];
    }
    return field > nothing * scale * length ? report::l1_error(value, exact, dx) : missed / (scale * length);
}

double largest(const Column& c) {
    return *std::max_element(c.begin(), c.end());
}

}  // namespace

void require_tube(const TubeScene& scene) {
    if (!(scene.jitter >= 0 && scene.jitter < 0.5)) throw std::invalid_argument{"jitter outside 0..0.5"};
    if (!(scene.smoothing >= 0) || (scene.smoothing > 0 && !scene.equal_masses))
        throw std::invalid_argument{"a smoothed start needs a width >= 0 and equal masses"};
    if (!(scene.time > 0)) throw std::invalid_argument{"time must be above 0"};
    if (!(scene.window[0] < scene.diaphragm && scene.diaphragm < scene.window[1]))
        throw std::invalid_argument{"the diaphragm is not inside the window"};
}

TubeScene with_heat(TubeScene scene, double least) {
    constexpr double little = 1e-12;
    const double dv = scene.left.v - scene.right.v;
    for (State* state : {&scene.left, &scene.right}) {
        if (state->rho > 0 && state->p == 0)
            state->p = std::max(little * std::max({scene.left.p, scene.right.p, state->rho * dv * dv}),
                                least * state->rho);
        if (state->rho > 0 && !(state->p > 0))
            throw std::invalid_argument{"nothing happens in cold gas that moves with one velocity"};
    }
    return scene;
}

double tube_end(const TubeScene& scene, const State& state, double side, double head, double reserve) {
    if (state.rho == 0) return 0;
    const double length = side * (scene.window[side < 0 ? 0 : 1] - scene.diaphragm);
    const double run = scene.time * side * state.v;  // how far the end itself goes outwards
    return side * std::max({length, length - run, reserve * (scene.time * side * head - run)});
}

std::array<std::size_t, 2> particles_of_sides(const TubeScene& scene, const TubeProblem& problem) {
    const TubeLattice lattice = lay_tube(scene, problem.density, problem.ends);
    std::array<std::size_t, 2> count{};
    for (std::size_t i = 0; i < lattice.free; ++i) {
        const double x = scene.diaphragm + lattice.x[i];
        if (x > scene.window[0] && x < scene.window[1]) ++count[lattice.side[i]];
    }
    return count;
}

TubeProblem gas_tube(const TubeScene& given) {
    require_tube(given);
    const TubeScene scene = with_heat(given);
    const exact::Riemann solution{scene.left, scene.right, scene.gamma};
    const ThermalState state{IdealGas{scene.gamma}};
    const auto sound_speed = [&](const State& s) {
        return s.rho > 0 ? state.sound_speed(s.rho, state.energy(s.rho, s.p)) : 0;
    };
    const auto momentum = [&](const State& s) { return s.rho > 0 ? std::abs(s.v) + sound_speed(s) : 0; };
    return {state,
            {scene.left, scene.right},
            {scene.left.rho, scene.right.rho},
            {tube_end(scene, scene.left, -1, solution.waves().left.head, 1),
             tube_end(scene, scene.right, 1, solution.waves().right.head, 1)},
            {momentum(scene.left), momentum(scene.right)},
            exact_tube(solution, scene, sound_speed)};
}

TubeRun run_tube(const TubeScene& scene, const Method<1>& method) {
    return run_tube(scene, method, gas_tube(scene));
}

TubeRun run_tube(const TubeScene& scene, const Method<1>& method, const TubeProblem& problem) {
    TubeLattice lattice = lay_tube(scene, problem.density, problem.ends);
    if (scene.smoothing > 0) smooth_positions(lattice, problem.density, scene.smoothing);
    const auto gas = fill(scene, method, problem, lattice);
    const Totals<1> before = gas->totals();
    const Column& x = gas->get<Position>()[0];
    const StepControl control{.end = scene.time, .most_steps = scene.most_steps, .progress = scene.progress};
    double t = 0;
    TubeRun run;
    run.seconds = march(*gas, t, control, [&](double now) {
                      require_order({x.data(), lattice.free}, now);
                      if (scene.watch) scene.watch(now, *gas);
                  }).seconds;
    gas->resolve(t);
    const Totals<1> after = gas->totals();
    run.energy_drift = std::abs(after.energy / before.energy - 1);
    run.momentum_drift = std::abs(after.momentum[0] - before.momentum[0]) / momentum_scale(problem, lattice);
    run.counters = gas->counters();
    run.whole = profile_of(*gas, lattice.free);
    compare(run, spacings(run.whole.x), problem.exact);
    return run;
}

report::Quantities TubeRun::errors() const {
    return {{"l1_rho", l1_rho},           {"l1_v", l1_v},      {"l1_p", l1_p}, {"l1_u", l1_u},
            {"overshoot_rho", overshoot}, {"wiggle_p", wiggle}};
}
report::Quantities TubeRun::drifts() const {
    return {{"energy_drift", energy_drift}, {"momentum_drift", momentum_drift}};
}
report::Quantities TubeRun::costs() const {
    return {{"steps", static_cast<double>(counters.steps)}, {"cpu_seconds", seconds, "s"}};
}

Profile exact_profile(const TubeScene& scene, double low, double high) {
    return exact_profile(gas_tube(scene).exact, low, high);
}
Profile exact_profile(const ExactTube& solution) {
    return exact_profile(solution, solution.window[0], solution.window[1]);
}

Profile exact_profile(const ExactTube& solution, double low, double high) {
    constexpr int points = 201;
    Column places;
    for (int k = 0; k < points; ++k) places.push_back(low + (high - low) * k / (points - 1));
    const double beside = 1e-9 * (high - low);
    for (const double jump : solution.jumps) {
        if (jump > low && jump < high) places.insert(places.end(), {jump - beside, jump + beside});
    }
    std::sort(places.begin(), places.end());
    Profile profile;
    for (const double x : places) append(profile, x, solution.at(x));
    return profile;
}

Column entropy_of(const Profile& profile, double gamma) {
    Column entropy(profile.x.size());
    for (std::size_t i = 0; i < entropy.size(); ++i)
        entropy[i] = profile.p[i] / std::pow(profile.rho[i], gamma);
    return entropy;
}

Column spacings(const Column& x) {
    Column dx(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, x.size() - 1);
        dx[i] = high > low ? (x[high] - x[low]) / static_cast<double>(high - low) : 0;
    }
    return dx;
}

void compare(TubeRun& run, const Column& all_dx, const ExactTube& solution) {
    const Profile& all = run.whole;
    run.profile = run.exact = {};
    Column dx;
    for (std::size_t i = 0; i < all.x.size(); ++i) {
        if (!(all.x[i] > solution.window[0] && all.x[i] < solution.window[1])) continue;
        dx.push_back(all_dx[i]);
        append(run.profile, all.x[i], {all.rho[i], all.v[i], all.p[i], all.u[i]});
        append(run.exact, all.x[i], solution.at(all.x[i]));
    }
    if (dx.empty()) return;
    run.l1_rho = relative_l1(run.profile.rho, run.exact.rho, dx, solution.scale.rho);
    run.l1_v = relative_l1(run.profile.v, run.exact.v, dx, solution.scale.v);
    run.l1_p = relative_l1(run.profile.p, run.exact.p, dx, solution.scale.p);
    run.l1_u = relative_l1(run.profile.u, run.exact.u, dx, solution.scale.u);
    run.overshoot = std::max(0.0, largest(run.profile.rho) / largest(run.exact.rho) - 1);
    if (solution.vacuum) return;
    const auto n = static_cast<std::ptrdiff_t>(all.x.size());
    const auto contact = std::lower_bound(all.x.begin(), all.x.end(), solution.contact) - all.x.begin();
    for (auto k = std::max<std::ptrdiff_t>(0, contact - 6); k < std::min(n, contact + 6); ++k)
        run.wiggle = std::max(run.wiggle, std::abs(all.p[static_cast<std::size_t>(k)] - solution.p_star) /
                                              std::max(solution.p_star, solution.p_outside));
}

}  // namespace sph::shocks
