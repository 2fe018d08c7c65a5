#include "chapters/03_euler_sph/scenes/patch.hpp"

namespace sph::euler {
namespace {

using K = AnyKernel<2>;
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
    Liquid liquid{scene.per_side * scene.per_side,
                  {h, K{"quintic"}},
                  {{1, scene.sound_speed, 7}},
                  Free{},
                  scene.threads};
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
    Drifts drifts{liquid};
    const double start = drifts.first().energy, spin = angular_momentum(p);
    liquid.integrate_by<RungeKutta4>();
    const long steps = std::lround(std::ceil(scene.time / (scene.courant * h / (scene.sound_speed + 1))));
    PatchRun run;
    double t = 0;
    long k = 0;
    march(liquid, t, {.end = scene.time, .steps = steps}, [&](double now) {
        ++k;
        if (k % 10 != 0 && k != steps && k != steps / 2) return;
        liquid.resolve(now);
        drifts.look();
        run.t.push_back(now);
        run.energy.push_back((liquid.totals().energy - start) / start);
        run.angular_momentum = std::max(run.angular_momentum, std::abs(angular_momentum(p) - spin) / moment);
        for (const double rho : p.rho) run.compression = std::max(run.compression, std::abs(rho - 1));
        if (k == steps / 2) {
            run.middle_x = p.x;
            run.middle_pressure = p.p;
        }
    });
    run.energy_drift = drifts.energy() / start;
    run.momentum = drifts.momentum() / speed;
    run.x = p.x;
    run.pressure = p.p;
    run.counters = liquid.counters();
    return run;
}

report::Quantities PatchRun::measured() const {
    return {{"energy_drift", energy_drift},
            {"momentum_drift", momentum},
            {"angular_momentum_drift", angular_momentum},
            {"compression", compression},
            {"steps", static_cast<double>(counters.steps)}};
}

}  // namespace sph::euler
