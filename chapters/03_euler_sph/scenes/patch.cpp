#include "chapters/03_euler_sph/scenes/patch.hpp"

namespace sph {
namespace {

using K = QuinticSpline<2>;
using Liquid = Gas<ContinuityH<K, PhiIsOne>, Barotropic<Cole>>;

/// (2.46) with V = L = 1, about the middle of the square.
Vector<2> velocity(double x, double y) {
    const double edge = std::exp(-4.0);
    return {std::exp(-square(4 * y)) - edge, edge - std::exp(-square(4 * x))};
}

double angular_momentum(const Liquid::P& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        sum += p.m[i] * (p.x[0][i] * p.v[1][i] - p.x[1][i] * p.v[0][i]);
    return sum;
}

}  // namespace

PatchRun run_patch(const PatchScene& scene) {
    const double dx = 1 / static_cast<double>(scene.per_side), h = 1.2 * dx;
    Liquid liquid{scene.per_side * scene.per_side, {h}, {{1, scene.sound_speed, 7}}, Free{}, scene.threads};
    auto& p = liquid.particles;
    p.x = make_points<2>(Arrangement::even, scene.per_side, 0, 1);
    double speed = 0, moment = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t a = 0; a < 2; ++a) p.x[a][i] -= 0.5;
        const Vector<2> v = velocity(p.x[0][i], p.x[1][i]);
        for (std::size_t a = 0; a < 2; ++a) p.v[a][i] = v[a];
        p.m[i] = dx * dx;
        p.rho[i] = 1;
        speed += p.m[i] * std::sqrt(dot(v, v));
        moment += p.m[i] * std::sqrt(dot(v, v) * (square(p.x[0][i]) + square(p.x[1][i])));
    }
    liquid.resolve(0);
    const double start = liquid.energy(), spin = angular_momentum(p);
    const Vector<2> momentum = liquid.momentum();
    RungeKutta4<Liquid::Motion> integrator{liquid.counters()};
    const auto rates = [&](double t) { liquid.rates(t); };
    const auto steps =
        static_cast<int>(std::ceil(scene.time / (scene.courant * h / (scene.sound_speed + 1))));
    PatchRun run;
    double t = 0;
    for (int k = 1; k <= steps; ++k) {
        integrator.step(p, t, scene.time / steps, rates);
        if (k % 10 != 0 && k != steps && k != steps / 2) continue;
        liquid.resolve(t);
        run.t.push_back(t);
        run.energy.push_back((liquid.energy() - start) / start);
        run.energy_drift = std::max(run.energy_drift, std::abs(run.energy.back()));
        const Vector<2> change = liquid.momentum() - momentum;
        for (const double component : change)
            run.momentum = std::max(run.momentum, std::abs(component) / speed);
        run.angular_momentum = std::max(run.angular_momentum, std::abs(angular_momentum(p) - spin) / moment);
        for (const double rho : p.rho) run.compression = std::max(run.compression, std::abs(rho - 1));
        if (k == steps / 2) {
            run.middle_x = p.x;
            run.middle_pressure = p.p;
        }
    }
    run.x = p.x;
    run.pressure = p.p;
    run.counters = liquid.counters();
    return run;
}

}  // namespace sph
