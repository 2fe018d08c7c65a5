#include "chapters/03_euler_sph/scenes/rarefaction.hpp"

#include "common/exact/rarefaction.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {
namespace {

/// Spacing of particle i: half the distance of its neighbours, all of it at an end.
double spacing(const Column& x, std::size_t i) {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, x.size() - 1);
    return (x[high] - x[low]) / static_cast<double>(high - low);
}

std::unique_ptr<LineGas> hot_gas(const RarefactionScene& scene, const GasMethod& method) {
    const IdealGas state{scene.gamma};
    auto gas = with_resolution(method, 1.0 / static_cast<double>(scene.n), [&](const auto& resolution) {
        return line_gas(scene.n, resolution, Thermal{state}, Free{}, scene.threads);
    });
    const auto place = [&](double share) {
        const double s = 2 * share - 1;
        return 0.5 * (scene.graded ? 0.2 * s + 0.8 * std::sin(std::numbers::pi / 2 * s) : s);
    };
    const auto n = static_cast<double>(scene.n);
    for (std::size_t i = 0; i < scene.n; ++i) {
        const auto k = static_cast<double>(i);
        gas->get<Position>()[0][i] = place((k + 0.5) / n);
        gas->get<Mass>()[i] = place((k + 1) / n) - place(k / n);
        gas->get<Density>()[i] = 1;
        gas->get<Pressure>()[i] = state.pressure(1, scene.u);
    }
    gas->start(0);
    return gas;
}

/// The step that sound crossing the least spacing allows.
double longest_step(const LineGas& gas, const RarefactionScene& scene) {
    const IdealGas state{scene.gamma};
    const Column &x = gas.get<Position>()[0], &u = gas.get<ThermalEnergy>();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        least = std::min(least, (x[i + 1] - x[i]) / state.sound_speed(1, std::max(u[i], u[i + 1])));
    return scene.courant * least;
}

}  // namespace

RarefactionRun run_rarefaction(const RarefactionScene& scene, const GasMethod& method) {
    const auto gas = hot_gas(scene, method);
    gas->integrate_by<RungeKutta4>();
    gas->limit_steps([&] { return longest_step(*gas, scene); });
    gas->resolve(0);
    const double energy = gas->totals().energy;
    const Column& x = gas->get<Position>()[0];
    double t = 0;
    march(*gas, t, {.end = scene.time, .progress = scene.progress},
          [&](double now) { require_order(x, now); });
    gas->resolve(t);
    const exact::Rarefaction exact{1, scene.u, scene.gamma, 0.5};
    RarefactionRun run;
    run.x = x;
    run.v = gas->get<Velocity>()[0];
    run.rho = gas->get<Density>();
    Column dx;
    for (std::size_t i = 0; i < scene.n; ++i) {
        dx.push_back(spacing(x, i));
        const auto e = exact.at(x[i], scene.time);
        run.exact_v.push_back(e.v);
        run.exact_rho.push_back(e.rho);
    }
    run.velocity_error = report::l1_error(run.v, run.exact_v, dx);
    run.density_error = report::l1_error(run.rho, run.exact_rho, dx);
    const Totals<1> totals = gas->totals();
    run.energy_drift = totals.energy / energy - 1;
    run.momentum = totals.momentum[0] / exact.sound_speed();
    run.edge = x.back();
    run.front = exact.front(scene.time);
    run.counters = gas->counters();
    return run;
}

report::Quantities RarefactionRun::measured() const {
    return {{"l1_v", velocity_error},
            {"l1_rho", density_error},
            {"energy_drift", energy_drift},
            {"momentum_drift", momentum}};
}

void RarefactionCommand::declare(app::CommandLine& line) {
    choice_.declare(line, resolution_names());
    line.number("gamma", gamma_, {1, 100, true}, "", "adiabatic index")
        .choice("spacing", spacing_, {"even", "graded"}, "of the particles, with masses in proportion")
        .integer("particles", particles_, 8, 4096, "of the gas");
}

void RarefactionCommand::run(report::Run& run) const {
    RarefactionScene scene;
    scene.n = static_cast<std::size_t>(particles_);
    scene.gamma = gamma_;
    scene.graded = spacing_ == "graded";
    scene.threads = run.threads();
    scene.time = 0.8 * 0.5 / IdealGas{gamma_}.sound_speed(1, scene.u);
    scene.progress = run.progress();
    const GasMethod& method = choice_.chosen();
    const RarefactionRun gas = run_rarefaction(scene, method);
    run.record(method.resolution, scene.n, gas.measured());
    run.write("profile.csv", report::csv({{"x", gas.x},
                                          {"v", gas.v},
                                          {"rho", gas.rho},
                                          {"exact_v", gas.exact_v},
                                          {"exact_rho", gas.exact_rho}}));
    plot::Figure figure{"rarefaction"};
    plot::beside_exact(figure.panel().labels("$x$", "$v$"), gas.x, gas.exact_v, gas.x, gas.v, 4);
    run.save(figure);
}

}  // namespace sph::euler
