#include <algorithm>

#include "chapters/04_artificial_viscosity/studies.hpp"
#include "common/app/error.hpp"

/// The scene of the reader's own: `run 04 --scene tube` with the chapter's options.
namespace sph::shocks {
namespace {

exact::Riemann::State state(const std::string& option, const std::vector<double>& values) {
    const exact::Riemann::State state{values[0], values[1], values[2]};
    if (state.rho < 0 || state.p < 0)
        throw app::UsageError{"--" + option +
                              ": density or pressure below 0 is not allowed; allowed: 0 and above"};
    if ((state.rho == 0) != (state.p == 0))
        throw app::UsageError{
            "--" + option +
            ": only one of density and pressure is 0, which is not allowed; allowed: both (a "
            "vacuum) or none"};
    return state;
}

const Method& chosen(const std::string& name) {
    if (name.empty()) return best_tube_method();
    std::vector<std::string> names;
    for (const Method& method : tube_methods()) names.push_back(method.name);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        std::string allowed;
        for (const std::string& known : names) allowed += ", " + known;
        throw app::UsageError{"--method: " + name + " is not allowed; allowed: list" + allowed};
    }
    return tube_method(name);
}

void draw(report::Run& run, const TubeScene& scene, const TubeRun& tube) {
    const Profile line = exact_profile(scene);
    plot::Figure figure{"tube", 2, 2};
    const auto panel = [&](int row, int column, const std::string& label, const Column& value,
                           const Column& exact) {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label);
        axes.curve(line.x, exact, exact_line());
        axes.points(tube.profile.x, value,
                    {.label = "SPH", .marker = plot::Marker::circle, .marker_size = 3});
    };
    panel(0, 0, "ρ", tube.profile.rho, line.rho);
    panel(0, 1, "$v$", tube.profile.v, line.v);
    panel(1, 0, "$P$", tube.profile.p, line.p);
    panel(1, 1, "$u$", tube.profile.u, line.u);
    run.save(figure);
}

}  // namespace

void Options::declare(app::CommandLine& line) {
    const app::Range scale{-1e12, 1e12};
    line.numbers("left", left, scale, "", "density, velocity and pressure at x < 0; 0,v,0: vacuum", 3)
        .numbers("right", right, scale, "", "density, velocity and pressure at x > 0", 3)
        .number("gamma", gamma, {1, 10, true}, "", "adiabatic index")
        .number("time", time, {0, 1e6, true}, "time", "how long the scene runs")
        .integer("particles", particles, 10, 1000000, "of equal mass in |x| < 0.5 at the start")
        .number("jitter", jitter, {0, 0.49}, "spacings", "largest random shift of each particle")
        .number("courant", courant, {0.001, 0.6}, "", "step over the shortest time between neighbours")
        .text("method", method, "NAME", "of dissipation; 'list' names them; default: the recommended one")
        .flag("all-runs", all_runs, "survival: both sizes and all disorders for every method; a minute");
}

void tube_scene(report::Run& run, const Options& options) {
    if (options.method == "list") {
        std::string names;
        for (const Method& method : tube_methods())
            names += method.name + (method.name == best_tube_method().name ? " (recommended)\n" : "\n");
        return run.print(names);
    }
    const Method& method = chosen(options.method);
    TubeScene scene{state("left", options.left), state("right", options.right), options.gamma, options.time};
    if (scene.left.rho == 0 && scene.right.rho == 0)
        throw app::UsageError{"--left: vacuum on both sides is not allowed; allowed: on one"};
    scene.n = static_cast<std::size_t>(options.particles);
    scene.jitter = options.jitter;
    scene.seed = run.seed();
    scene.courant = options.courant;
    scene.threads = run.threads();
    const TubeRun tube = [&] {
        try {
            return run_tube(scene, method);
        } catch (const std::invalid_argument& error) {
            throw app::UsageError{std::string{"--left, --right, --time: "} + error.what()};
        }
    }();
    if (tube.profile.x.empty()) throw app::UsageError{"--time: the gas has left |x| < 0.5; allowed: less"};
    const auto row = [&](const std::string& quantity, double value) {
        run.result(method.name, options.particles, quantity, value);
    };
    row("l1_rho", tube.l1_rho);
    row("l1_v", tube.l1_v);
    row("l1_p", tube.l1_p);
    row("l1_u", tube.l1_u);
    row("overshoot_rho", tube.overshoot);
    row("wiggle_p", tube.wiggle);
    row("energy_drift", tube.energy_drift);
    row("momentum_drift", tube.momentum_drift);
    row("steps", static_cast<double>(tube.counters.steps));
    row("pairs", static_cast<double>(tube.counters.pairs));
    run.result(method.name, options.particles, "cpu_seconds", tube.seconds, "s");
    std::string csv = "x,rho,v,p,u,exact_rho,exact_v,exact_p,exact_u\n";
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i)
        csv += report::csv_row({tube.profile.x[i], tube.profile.rho[i], tube.profile.v[i], tube.profile.p[i],
                                tube.profile.u[i], tube.exact.rho[i], tube.exact.v[i], tube.exact.p[i],
                                tube.exact.u[i]});
    run.write("profile.csv", csv);
    draw(run, scene, tube);
}

}  // namespace sph::shocks
