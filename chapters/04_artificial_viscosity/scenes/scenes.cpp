#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube_report.hpp"
#include "common/app/error.hpp"

/// The scene of the reader's own: `run 04 --scene tube` with the chapter's options.
namespace sph::shocks {

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
    if (options.method == "list") return run.print(method_list(tube_methods()));
    const Method& method = choose_method(options.method, tube_methods());
    TubeScene scene{tube_state("left", options.left), tube_state("right", options.right), options.gamma,
                    options.time};
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
    report_tube(run, method.name, options.particles, tube, exact_profile(scene));
}

}  // namespace sph::shocks
