#include "chapters/04_artificial_viscosity/scenes/woodward_colella.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "common/exact/woodward_colella.hpp"
#include "common/report/norms.hpp"
#include "common/report/timer.hpp"

namespace sph {

TubeRun run_blast_waves(const BlastWaves& scene, const Method& method) {
    const double gamma = exact::WoodwardColella::gamma, dx = 1.0 / static_cast<double>(scene.n);
    const auto gas = make_model(method, scene.n, gamma, Box<1>{{0}, {1}, Face::mirror}, scene.threads);
    std::mt19937_64 random{scene.seed};
    for (std::size_t i = 0; i < scene.n; ++i) {
        const double even = (static_cast<double>(i) + 0.5) * dx;
        const double p = even < 0.1 ? 1000 : even < 0.9 ? 0.01 : 100;
        gas->set(i, {even + scene.jitter * dx * random_shift(random)}, {0}, dx, 1, p / (gamma - 1));
    }
    gas->resolve(0);
    const double energy = gas->energy();
    double t = 0;
    const double begin = report::thread_cpu_seconds();
    gas->advance(t, exact::WoodwardColella::time, scene.courant,
                 [&](double now) { require_order(gas->x()[0], scene.n, now); });
    TubeRun run;
    run.seconds = report::thread_cpu_seconds() - begin;
    run.energy_drift = std::abs(gas->energy() / energy - 1);
    run.counters = gas->counters();
    run.profile = {gas->x()[0], gas->rho(), gas->v()[0], gas->p(), gas->u()};
    compare_blast_waves(run, spacings(run.profile.x));
    return run;
}

void compare_blast_waves(TubeRun& run, const Column& dx) {
    const exact::WoodwardColella reference;
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

}  // namespace sph
