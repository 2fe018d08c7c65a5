#include "chapters/04_artificial_viscosity/scenes/woodward_colella.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/woodward_colella.hpp"
#include "common/report/norms.hpp"

namespace sph::shocks {

double blast_waves_pressure(double x) {
    return x < 0.1 ? 1000 : x < 0.9 ? 0.01 : 100;
}

TubeRun run_blast_waves(const BlastWaves& scene, const Method<1>& method) {
    const double dx = 1.0 / static_cast<double>(scene.n);
    const auto gas = method.make({.n = scene.n,
                                  .state = IdealGas{exact::WoodwardColella::gamma},
                                  .box = Box<1>{{0}, {1}, Face::mirror},
                                  .courant = scene.courant,
                                  .threads = scene.threads});
    std::mt19937_64 random{scene.seed};
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double even = (static_cast<double>(i) + 0.5) * dx;
        gas->place(i, {even + scene.jitter * dx * random_shift(random)}, {0}, dx, 1,
                   blast_waves_pressure(even));
    }
    gas->start(0);
    gas->resolve(0);
    const double energy = gas->totals().energy;
    const Column& x = gas->get<Position>()[0];
    double t = 0;
    TubeRun run;
    run.seconds = march(*gas, t, {.end = exact::WoodwardColella::time, .most_steps = scene.most_steps},
                        [&](double now) { require_order(x, now); })
                      .seconds;
    gas->resolve(t);
    run.energy_drift = std::abs(gas->totals().energy / energy - 1);
    run.counters = gas->counters();
    run.whole = {x, gas->get<Density>(), gas->get<Velocity>()[0], gas->get<Pressure>(),
                 gas->get<ThermalEnergy>()};
    compare_blast_waves(run, spacings(x));
    return run;
}

void compare_blast_waves(TubeRun& run, const Column& dx) {
    const exact::WoodwardColella reference;
    run.profile = run.whole;
    run.exact.x = run.profile.x;
    for (const double x : run.profile.x) {
        const auto state = reference.at(std::clamp(x, 0.0, 1.0));
        run.exact.rho.push_back(state.rho);
        run.exact.v.push_back(state.v);
        run.exact.p.push_back(state.p);
        run.exact.u.push_back(state.u);
    }
    run.l1_rho = report::l1_error(run.profile.rho, run.exact.rho, dx);
    run.l1_v = report::l1_error(run.profile.v, run.exact.v, dx);
    run.l1_p = report::l1_error(run.profile.p, run.exact.p, dx);
    run.l1_u = report::l1_error(run.profile.u, run.exact.u, dx);
}

}  // namespace sph::shocks
