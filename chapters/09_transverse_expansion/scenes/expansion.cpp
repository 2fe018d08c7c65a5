#include "chapters/09_transverse_expansion/scenes/expansion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "common/core/unstable.hpp"

namespace sph::transverse {
namespace {

Disc places_of(const Flow& flow, const PlaneScene& scene, Places places) {
    switch (places) {
        case Places::hexagonal:
            return hexagonal_disc(scene.n, flow.radius);
        case Places::rings:
            return ring_disc(scene.n, flow.radius);
        case Places::relaxed:
            return relaxed_disc(scene.n, flow.radius, scene.seed, scene.threads);
        case Places::spiral:
            return spiral_disc(scene.n, flow.radius, [](double) { return 1.0; });
        case Places::graded:
            return spiral_disc(scene.n, flow.radius, flow.spacing);
    }
    throw std::invalid_argument{"no such places"};
}

double by_length(double x, double r) {
    return r > 0 ? x / r : 0;
}

}  // namespace

void solve_masses(Integrated<2>& fluid, const Column& wanted, double tau, double total) {
    constexpr int rounds = 3;
    constexpr double most = 1.3;
    Column &nu = fluid.get<Entropy>(), &s_star = fluid.get<EntropyDensity>();
    for (int round = 0; round < rounds; ++round) {
        s_star = wanted;
        fluid.start(tau);
        fluid.resolve(tau);
        for (std::size_t i = 0; i < nu.size(); ++i)
            nu[i] *= std::clamp(wanted[i] / s_star[i], 1 / most, most);
    }
    s_star = wanted;
    if (!(total > 0)) return;
    double sum = 0;
    for (const double one : nu) sum += one;
    // Lengths and masses together leave every s* as it is.
    const double by_area = total / sum, by_side = std::sqrt(by_area);
    for (double& one : nu) one *= by_area;
    for (Column& axis : fluid.get<Position>()) {
        for (double& x : axis) x *= by_side;
    }
}

std::unique_ptr<Integrated<2>> plane_fluid(const Flow& flow, const PlaneScene& scene,
                                           const PlaneMethod& method) {
    const Disc disc = places_of(flow, scene, method.places);
    const std::size_t n = disc.area.size();
    auto fluid = method.make(
        {n, flow.radius, flow.c2, disc.x, scene.courant, scene.order, scene.careful, scene.threads});
    Column& s_star = fluid->get<EntropyDensity>();
    double total = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double r = std::hypot(disc.x[0][i], disc.x[1][i]);
        const FlowState state = flow.start(r);
        s_star[i] = flow.tau0 * std::pow(state.temperature, 1 / flow.c2) * std::sqrt(1 + square(state.u_r));
        fluid->get<Entropy>()[i] = disc.area[i] * s_star[i];
        total += fluid->get<Entropy>()[i];
        for (std::size_t a = 0; a < 2; ++a) {
            fluid->get<Position>()[a][i] = disc.x[a][i];
            fluid->get<FourVelocity>()[a][i] = state.u_r * by_length(disc.x[a][i], r);
        }
    }
    if (method.solved) solve_masses(*fluid, Column{s_star}, flow.tau0, flow.has_edge ? total : 0);
    fluid->start(flow.tau0);
    return fluid;
}

Snapshot snapshot_of(const Integrated<2>& fluid, const Flow& flow, double tau) {
    const FlowProfile exact = flow.exact(tau);
    Snapshot shot;
    shot.time = tau;
    const auto &x = fluid.get<Position>(), &U = fluid.get<FourVelocity>();
    shot.x = x[0], shot.y = x[1];
    double difference_T = 0, sum_T = 0, difference_eps = 0, sum_eps = 0, difference_u = 0, sum_u = 0;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        const double r = std::hypot(x[0][i], x[1][i]), s_star = fluid.get<EntropyDensity>()[i];
        const double s = s_star / (tau * std::sqrt(1 + square(U[0][i]) + square(U[1][i])));
        const double T = std::pow(s, flow.c2), u = by_length(U[0][i] * x[0][i] + U[1][i] * x[1][i], r);
        const FlowState state = exact(r);
        const double exact_eps = std::pow(state.temperature, 1 + 1 / flow.c2);
        const double area = fluid.get<Entropy>()[i] / s_star;
        shot.r.push_back(r), shot.temperature.push_back(T), shot.u_r.push_back(u), shot.eps.push_back(s * T);
        shot.exact_temperature.push_back(state.temperature), shot.exact_u_r.push_back(state.u_r);
        shot.exact_eps.push_back(exact_eps), shot.area.push_back(area);
        if (r >= flow.window) continue;
        difference_T += area * std::abs(T - state.temperature), sum_T += area * state.temperature;
        difference_eps += area * std::abs(s * T - exact_eps), sum_eps += area * exact_eps;
        difference_u += area * std::abs(u - state.u_r), sum_u += area * state.u_r;
        if (r < flow.window / 10) shot.axis = std::max(shot.axis, std::abs(T / state.temperature - 1));
    }
    shot.l1_temperature = difference_T / sum_T;
    shot.l1_eps = difference_eps / sum_eps;
    if (sum_u > 0) shot.l1_u = difference_u / sum_u;
    return shot;
}

std::vector<Snapshot> run_plane(const Flow& flow, const PlaneScene& scene, const PlaneMethod& method) {
    if (scene.n < 20) throw std::invalid_argument{"fewer than twenty particles"};
    const auto fluid = plane_fluid(flow, scene, method);
    double tau = flow.tau0, seconds = 0;
    fluid->resolve(tau);
    const Totals<2> first = fluid->totals();
    std::vector<Snapshot> shots;
    for (const double end : scene.times) {
        seconds += march(*fluid, tau, {.end = end, .steps = scene.steps, .progress = scene.progress}).seconds;
        fluid->resolve(tau);
        Snapshot& shot = shots.emplace_back(snapshot_of(*fluid, flow, tau));
        const Totals<2> now = fluid->totals();
        double whole = 0;
        for (std::size_t i = 0; i < shot.x.size(); ++i)
            whole += fluid->get<Entropy>()[i] *
                     std::hypot(fluid->get<MomentumPerCharge>()[0][i], fluid->get<MomentumPerCharge>()[1][i]);
        shot.momentum =
            std::hypot(now.momentum[0] - first.momentum[0], now.momentum[1] - first.momentum[1]) / whole;
        if (flow.has_edge) shot.entropy = now.mass / (flow.tau0 * pi * square(flow.radius)) - 1;
        shot.seconds = seconds;
        shot.counters = fluid->counters();
    }
    return shots;
}

report::Quantities Snapshot::measured() const {
    return {{"l1_temperature", l1_temperature},
            {"l1_eps", l1_eps},
            {"l1_u", l1_u},
            {"axis", axis},
            {"momentum_drift", momentum},
            {"entropy_drift", entropy},
            {"steps", static_cast<double>(counters.steps)},
            {"pairs", static_cast<double>(counters.pairs)}};
}

}  // namespace sph::transverse
