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

std::unique_ptr<Simulation<1>> fill(const TubeScene& scene, const Method<1>& method,
                                    const TubeProblem& problem, const TubeLattice& lattice) {
    const std::array sides{scene.left, scene.right};
    auto gas = method.make({.n = lattice.x.size(),
                            .state = problem.state,
                            .box = Box<1>{{-1}, {1}, Face::free},
                            .courant = scene.courant,
                            .threads = scene.threads});
    for (std::size_t i = 0; i < lattice.x.size(); ++i) {
        const State& state = sides[lattice.side[i]];
        gas->place(i, {lattice.x[i]}, {state.v}, lattice.m, state.rho, state.p);
    }
    for (const Group& layer : lattice.layers) gas->groups().hold(layer.name, layer.begin, layer.end);
    gas->start(0);
    gas->resolve(0);
    return gas;
}

/// sum m (|v| + c_s) at the start.
double momentum_scale(const TubeProblem& problem, const TubeLattice& lattice) {
    double scale = 0;
    for (const std::size_t side : lattice.side) scale += lattice.m * problem.momentum[side];
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

double largest(const Column& c) {
    return *std::max_element(c.begin(), c.end());
}

}  // namespace

void require_tube(const TubeScene& scene) {
    for (const State* state : {&scene.left, &scene.right}) {
        if (state->rho > 0 && !(state->p > 0))
            throw std::invalid_argument{"a gas without pressure has no time step; allowed: p above 0"};
    }
    if (!(scene.jitter >= 0 && scene.jitter < 0.5)) throw std::invalid_argument{"jitter outside 0..0.5"};
    if (!(scene.time > 0)) throw std::invalid_argument{"time must be above 0"};
}

double tube_end(const TubeScene& scene, const State& state, double side, double head, double reserve) {
    if (state.rho == 0) return 0;
    const double run = scene.time * side * state.v;  // how far the end itself goes outwards
    return side * std::max({0.5, 0.5 - run, reserve * (scene.time * side * head - run)});
}

TubeProblem gas_tube(const TubeScene& scene) {
    require_tube(scene);
    const exact::Riemann solution{scene.left, scene.right, scene.gamma};
    const ThermalState state{IdealGas{scene.gamma}};
    const auto momentum = [&](const State& s) {
        return s.rho > 0 ? std::abs(s.v) + state.sound_speed(s.rho, state.energy(s.rho, s.p)) : 0;
    };
    return {state,
            {scene.left.rho, scene.right.rho},
            {tube_end(scene, scene.left, -1, solution.waves().left.head, 1),
             tube_end(scene, scene.right, 1, solution.waves().right.head, 1)},
            {momentum(scene.left), momentum(scene.right)},
            exact_tube(solution, scene.time)};
}

TubeRun run_tube(const TubeScene& scene, const Method<1>& method) {
    return run_tube(scene, method, gas_tube(scene));
}

TubeRun run_tube(const TubeScene& scene, const Method<1>& method, const TubeProblem& problem) {
    const TubeLattice lattice = lay_tube(problem.density, problem.ends, scene.n, scene.jitter, scene.seed);
    const auto gas = fill(scene, method, problem, lattice);
    const Totals<1> before = gas->totals();
    const Column& x = gas->get<Position>()[0];
    const StepControl control{.end = scene.time, .most_steps = scene.most_steps, .progress = scene.progress};
    double t = 0;
    TubeRun run;
    run.seconds = march(*gas, t, control, [&](double now) {
                      require_order({x.data(), lattice.free}, now);
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
    return exact_profile(exact_tube(exact::Riemann{scene.left, scene.right, scene.gamma}, scene.time), low,
                         high);
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
        if (!(std::abs(all.x[i]) < 0.5)) continue;
        dx.push_back(all_dx[i]);
        append(run.profile, all.x[i], {all.rho[i], all.v[i], all.p[i], all.u[i]});
        append(run.exact, all.x[i], solution.at(all.x[i]));
    }
    if (dx.empty()) return;
    const auto error = [&](const Column& value, const Column& exact) {
        const bool zero = std::all_of(exact.begin(), exact.end(), [](double e) { return e == 0; });
        return zero ? 0 : report::l1_error(value, exact, dx);
    };
    run.l1_rho = error(run.profile.rho, run.exact.rho);
    run.l1_v = error(run.profile.v, run.exact.v);
    run.l1_p = error(run.profile.p, run.exact.p);
    run.l1_u = error(run.profile.u, run.exact.u);
    run.overshoot = std::max(0.0, largest(run.profile.rho) / largest(run.exact.rho) - 1);
    if (solution.vacuum) return;
    const auto n = static_cast<std::ptrdiff_t>(all.x.size());
    const auto contact = std::lower_bound(all.x.begin(), all.x.end(), solution.contact) - all.x.begin();
    for (auto k = std::max<std::ptrdiff_t>(0, contact - 6); k < std::min(n, contact + 6); ++k)
        run.wiggle = std::max(run.wiggle, std::abs(all.p[static_cast<std::size_t>(k)] / solution.p_star - 1));
}

}  // namespace sph::shocks
