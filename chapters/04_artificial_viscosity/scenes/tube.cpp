#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "common/core/unstable.hpp"
#include "common/report/norms.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

using State = exact::Riemann::State;

double sound_speed(const State& state, double gamma) {
    return std::sqrt(gamma * state.p / state.rho);
}

/// The speed at which the outermost wave runs into the state, away from the middle.
double wave_speed(const State& state, double p_star, double gamma) {
    const double c_s = sound_speed(state, gamma), ratio = p_star / state.p;
    return ratio > 1 ? c_s * std::sqrt((gamma + 1) / (2 * gamma) * ratio + (gamma - 1) / (2 * gamma)) : c_s;
}

/// How far one side must reach, side = -1 or +1.
double reach(const TubeScene& scene, const State& state, double side, double p_star) {
    if (state.rho == 0) return 0;
    const double run = scene.time * side * state.v;  // how far the end itself goes outwards
    return std::max({0.5, 0.5 - run, scene.time * wave_speed(state, p_star, scene.gamma)});
}

std::unique_ptr<Model<1>> make_tube(const TubeScene& scene, const Method& method) {
    const std::array sides{scene.left, scene.right};
    const TubeLattice lattice =
        lay_tube({scene.left.rho, scene.right.rho}, tube_ends(scene), scene.n, scene.jitter, scene.seed);
    auto gas =
        make_model(method, lattice.x.size(), scene.gamma, Box<1>{{-1}, {1}, Face::free}, scene.threads);
    for (std::size_t i = 0; i < lattice.x.size(); ++i) {
        const State& state = sides[lattice.side[i]];
        gas->set(i, {lattice.x[i]}, {state.v}, lattice.m, state.rho,
                 state.p / (state.rho * (scene.gamma - 1)));
    }
    gas->fix_from(lattice.moving);
    return gas;
}

void append(Profile& profile, double x, const exact::Riemann::Point& at) {
    profile.x.push_back(x);
    profile.rho.push_back(at.rho);
    profile.v.push_back(at.v);
    profile.p.push_back(at.p);
    profile.u.push_back(at.u);
}

void require_sound(const TubeScene& scene) {
    for (const State* state : {&scene.left, &scene.right}) {
        if (state->rho > 0 && !(state->p > 0))
            throw std::invalid_argument{"a gas without pressure has no time step; allowed: p above 0"};
    }
    if (!(scene.jitter >= 0 && scene.jitter < 0.5)) throw std::invalid_argument{"jitter outside 0..0.5"};
    if (!(scene.time > 0)) throw std::invalid_argument{"time must be above 0"};
}

}  // namespace

void require_order(const Column& x, std::size_t n, double t) {
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double gap = x[i + 1] - x[i];
        if (!(gap > 0)) throw Unstable{t, i, "the distance to the next particle", gap};
    }
}

Column spacings(const Column& x) {
    Column dx(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, x.size() - 1);
        dx[i] = high > low ? (x[high] - x[low]) / static_cast<double>(high - low) : 0;
    }
    return dx;
}

TubeRun run_tube(const TubeScene& scene, const Method& method) {
    require_sound(scene);
    const exact::Riemann solution{scene.left, scene.right, scene.gamma};
    const auto gas = make_tube(scene, method);
    gas->resolve(0);
    const double energy = gas->energy(), momentum = gas->momentum()[0];
    double scale = 0;
    for (std::size_t i = 0; i < gas->size(); ++i)
        scale += gas->m()[i] *
                 (std::abs(gas->v()[0][i]) + std::sqrt(scene.gamma * (scene.gamma - 1) * gas->u()[i]));
    double t = 0;
    const double begin = report::thread_cpu_seconds();
    gas->advance(t, scene.time, scene.courant, [&](double now) {
        require_order(gas->x()[0], gas->moving(), now);
        require_fewer_steps(*gas, scene.most_steps, now);
    });
    TubeRun run;
    run.seconds = report::thread_cpu_seconds() - begin;
    run.energy_drift = std::abs(gas->energy() / energy - 1);
    run.momentum_drift = std::abs(gas->momentum()[0] - momentum) / scale;
    run.counters = gas->counters();
    const auto moving = static_cast<std::ptrdiff_t>(gas->moving());
    const auto part = [moving](const Column& c) { return Column(c.begin(), c.begin() + moving); };
    run.profile = {part(gas->x()[0]), part(gas->rho()), part(gas->v()[0]), part(gas->p()), part(gas->u())};
    compare(run, spacings(run.profile.x), exact_tube(solution, scene.time));
    return run;
}

Profile exact_profile(const TubeScene& scene, double low, double high) {
    return exact_profile(exact_tube(exact::Riemann{scene.left, scene.right, scene.gamma}, scene.time), low,
                         high);
}

Profile exact_profile(const ExactTube& solution, double low, double high) {
    constexpr int points = 1001;
    Profile profile;
    for (int k = 0; k < points; ++k) {
        const double x = low + (high - low) * k / (points - 1);
        append(profile, x, solution.at(x));
    }
    return profile;
}

std::array<double, 2> tube_ends(const TubeScene& scene) {
    const double p_star = exact::Riemann{scene.left, scene.right, scene.gamma}.star().p;
    return {-reach(scene, scene.left, -1, p_star), reach(scene, scene.right, 1, p_star)};
}

void compare(TubeRun& run, const Column& all_dx, const ExactTube& solution) {
    const Profile all = std::move(run.profile);
    run.profile = {};
    Column dx;
    for (std::size_t i = 0; i < all.x.size(); ++i) {
        if (!(std::abs(all.x[i]) < 0.5)) continue;
        const auto exact = solution.at(all.x[i]);
        dx.push_back(all_dx[i]);
        append(run.profile, all.x[i], {all.rho[i], all.v[i], all.p[i], all.u[i]});
        append(run.exact, all.x[i], exact);
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
    const auto largest = [](const Column& c) { return *std::max_element(c.begin(), c.end()); };
    run.overshoot = std::max(0.0, largest(run.profile.rho) / largest(run.exact.rho) - 1);
    if (solution.vacuum) return;
    const auto n = static_cast<std::ptrdiff_t>(all.x.size());
    const auto contact = std::lower_bound(all.x.begin(), all.x.end(), solution.contact) - all.x.begin();
    for (auto k = std::max<std::ptrdiff_t>(0, contact - 6); k < std::min(n, contact + 6); ++k)
        run.wiggle = std::max(run.wiggle, std::abs(all.p[static_cast<std::size_t>(k)] / solution.p_star - 1));
}

}  // namespace sph
