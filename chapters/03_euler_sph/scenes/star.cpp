#include "chapters/03_euler_sph/scenes/star.hpp"

#include "common/exact/toy_star_modes.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {
namespace {

/// The part of a velocity that is the mode, weighted by mass.
double projection(const LineGas& gas, const Column& eigenfunction) {
    double sum = 0;
    for (std::size_t i = 0; i < gas.size(); ++i)
        sum += gas.get<Mass>()[i] * gas.get<Velocity>()[0][i] * eigenfunction[i];
    return sum;
}

/// The exact radius-to-second-moment relation: <x^2> = R^2/(2/(gamma - 1) + 3).
double radius_of(const LineGas& gas, double gamma) {
    double mass = 0, moment = 0;
    for (std::size_t i = 0; i < gas.size(); ++i) {
        const double m = gas.get<Mass>()[i];
        mass += m;
        moment += m * square(gas.get<Position>()[0][i]);
    }
    return std::sqrt(moment / mass * (2 / (gamma - 1) + 3));
}

/// Against the exact star at the end, by the widths of the particles.
void compare(NonlinearRun& run, const LineGas& gas, const exact::ToyStar& star, double t) {
    for (std::size_t k = 0; k < run.t.size(); ++k) {
        run.exact_radius.push_back(star.at(run.t[k]).radius);
        run.radius_error = std::max(run.radius_error, std::abs(run.radius[k] / run.exact_radius[k] - 1));
    }
    run.x = gas.get<Position>()[0];
    run.rho = gas.get<Density>();
    run.v = gas.get<Velocity>()[0];
    const auto end = star.at(t);
    Column width;
    for (std::size_t i = 0; i < run.x.size(); ++i) {
        run.exact_rho.push_back(end.density(run.x[i]));
        run.exact_v.push_back(end.velocity(run.x[i]));
        width.push_back(gas.get<Mass>()[i] / run.rho[i]);
    }
    // A star that does not move at the end has no relative error.
    if (std::any_of(run.exact_v.begin(), run.exact_v.end(), [](double v) { return v != 0; }))
        run.velocity_error = report::l1_error(run.v, run.exact_v, width);
}

}  // namespace

void fill_star(LineGas& gas, const StarScene& scene) {
    const StarPoints points = star_points(scene);
    gas.get<Position>()[0] = points.x;
    gas.get<Mass>() = points.m;
    for (std::size_t i = 0; i < scene.n; ++i) gas.get<Density>()[i] = points.m[i] / points.width[i];
    gas.start(0);
}

std::unique_ptr<LineGas> star_gas(const StarScene& scene, const GasMethod& method) {
    auto gas = with_resolution_at_rest(method, scene.mean_spacing(), [&](const auto& resolution) {
        return line_gas(scene.n, resolution, Barotropic<Polytrope>{scene.state()}, Free{}, scene.threads,
                        LinearForce{1});
    });
    fill_star(*gas, scene);
    return gas;
}

double star_step(const LineGas& gas, const StarScene& scene, double courant) {
    const Column &m = gas.get<Mass>(), &rho = gas.get<Density>();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m.size(); ++i)
        least = std::min(least, m[i] / rho[i] / scene.state().sound_speed(rho[i]));
    return courant * least;
}

StarRun run_mode(const StarScene& scene, const GasMethod& method, int mode, int periods, double phase_step) {
    const auto gas = star_gas(scene, method);
    const Dense J = relax(*gas);
    constexpr double amplitude = 1e-6;
    Column shape, &v = gas->get<Velocity>()[0];
    for (const double x : gas->get<Position>()[0])
        shape.push_back(exact::toy_star_velocity(scene.gamma, mode, std::clamp(x, -1.0, 1.0)));
    for (std::size_t i = 0; i < scene.n; ++i) v[i] = amplitude * shape[i];
    // The fastest oscillation of the discrete star, by Gershgorin; RK4 is stable to 2.8 of its phase.
    double fastest2 = 0;
    for (std::size_t i = 0; i < J.size(); ++i) {
        double row = 0;
        for (std::size_t j = 0; j < J.size(); ++j) row += std::abs(J(i, j));
        fastest2 = std::max(fastest2, row);
    }
    const double expected = exact::toy_star_frequency(scene.gamma, mode);
    const double dt = std::min(2 / std::sqrt(fastest2), phase_step / expected);
    gas->integrate_by<RungeKutta4>();
    gas->limit_steps([dt] { return dt; });
    const double start = projection(*gas, shape);
    double t = 0, before = 1;
    std::vector<double> falls;  // times at which the velocity changes from + to -: whole periods apart
    march(*gas, t, {.end = std::numeric_limits<double>::max()}, [&](double when) {
        const double now = projection(*gas, shape) / start;
        if (before > 0 && now <= 0) falls.push_back(when - std::asin(std::min(1.0, -now)) / expected);
        before = now;
        return falls.size() <= static_cast<std::size_t>(periods);
    });
    StarRun run;
    run.omega = 2 * std::numbers::pi * periods / (falls.back() - falls.front());
    march(*gas, t, {.end = 2 * std::numbers::pi / expected * (periods + 1)});  // all velocity again
    run.x = gas->get<Position>()[0];
    for (std::size_t i = 0; i < scene.n; ++i) {
        run.v.push_back(v[i] / amplitude);
        run.exact_v.push_back(shape[i] * std::cos(expected * t));
    }
    return run;
}

NonlinearRun run_nonlinear(const StarScene& scene, const GasMethod& method, double A_0, double time,
                           double courant) {
    const auto gas = star_gas(scene, method);
    relax(*gas);
    for (std::size_t i = 0; i < scene.n; ++i) gas->get<Velocity>()[0][i] = A_0 * gas->get<Position>()[0][i];
    const exact::ToyStar star = scene.exact(A_0);
    gas->rates(0);
    gas->counters() = {};  // of the oscillation only
    Drifts drifts{*gas};
    // Time steps suit the star at its smallest: spacing/c_s goes as radius^((gamma + 1)/2).
    double smallest = 1;
    for (int k = 0; k <= 1000; ++k) smallest = std::min(smallest, star.at(star.period() * k / 1000).radius);
    const double dt = star_step(*gas, scene, courant) * std::pow(smallest, (scene.gamma + 1) / 2);
    const long steps = std::lround(std::ceil(time / dt)), shown = std::max(1L, steps / 400);
    NonlinearRun run;
    double t = 0;
    long step = 0;
    run.seconds = march(*gas, t, {.end = time, .steps = steps, .progress = scene.progress}, [&](double now) {
                      drifts.look();
                      if (++step % shown != 0 && step != steps) return;
                      run.t.push_back(now);
                      run.radius.push_back(radius_of(*gas, scene.gamma));
                      run.energy.push_back(gas->totals().energy / drifts.first().energy - 1);
                  }).seconds;
    run.energy_drift = drifts.energy() / std::abs(drifts.first().energy);
    run.momentum = gas->totals().momentum[0];
    run.counters = gas->counters();
    compare(run, *gas, star, t);
    return run;
}

report::Quantities NonlinearRun::measured() const {
    report::Quantities all{{"radius_error", radius_error}};
    if (velocity_error > 0) all.push_back({"l1_v", velocity_error});
    all.push_back({"energy_drift", energy_drift});
    all.push_back({"momentum_drift", momentum});
    all.push_back({"steps", static_cast<double>(counters.steps)});
    all.push_back({"pairs", static_cast<double>(counters.pairs)});
    return all;
}

void StarCommand::declare(app::CommandLine& line) {
    choice_.declare(line, resolutions_at_rest());
    line.number("gamma", gamma_, {1, 100, true}, "", "adiabatic index; above 1.019 unless masses are equal")
        .number("amplitude", amplitude_, {0, 10}, "Omega", "A_0: v = A_0 x at t = 0")
        .choice("spacing", spacing_, {"even", "graded", "masses"}, "of the particles")
        .integer("particles", particles_, 8, 1000, "of the star")
        .number("time", time_, {0.01, 100}, "1/Omega", "how long it runs");
}

void StarCommand::run(report::Run& run) const {
    StarScene scene;
    scene.n = static_cast<std::size_t>(particles_);
    scene.gamma = gamma_;
    scene.spacing = spacing_ == "even"     ? Spacing::even
                    : spacing_ == "masses" ? Spacing::masses
                                           : Spacing::graded;
    // The density at the edge falls like a power of 1/(gamma - 1): with even spacing masses would be lost.
    if (scene.spacing != Spacing::masses)
        app::require_above("gamma", gamma_, 1.019, "with --spacing " + spacing_);
    scene.threads = run.threads();
    scene.progress = run.progress();
    const GasMethod& method = choice_.chosen();
    const NonlinearRun star = run_nonlinear(scene, method, amplitude_, time_);
    run.record(method.resolution, scene.n, star.measured());
    run.write("profile.csv", report::csv({{"x", star.x},
                                          {"rho", star.rho},
                                          {"v", star.v},
                                          {"exact_rho", star.exact_rho},
                                          {"exact_v", star.exact_v}}));
    plot::Figure figure{"star"};
    plot::beside_exact(figure.panel().labels("$x$", "ρ"), star.x, star.exact_rho, star.x, star.rho, 4);
    run.save(figure);
}

}  // namespace sph::euler
