
#include "chapters/03_euler_sph/dispersion.hpp"
#include "chapters/03_euler_sph/scenes/rarefaction_scene.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"
#include "common/app/error.hpp"

/// Scenes of the reader's own: `run 03 --scene NAME` with the chapter's options.
namespace sph::euler {
namespace {

GasScheme scheme_of(const Options& options) {
    if (std::find(dynamic_kernel_names().begin(), dynamic_kernel_names().end(), options.kernel) ==
        dynamic_kernel_names().end())
        throw app::UsageError{"--kernel: " + options.kernel +
                              " is not allowed in this scene; allowed: cubic, quintic, super-gaussian"};
    return {options.resolution, options.kernel, options.h_over_dx};
}

/// One panel: values against the exact ones over x.
void draw(report::Run& run, const std::string& name, const std::string& label, const Column& x,
          const Column& value, const Column& exact) {
    plot::Figure figure{name};
    plot::Panel& panel = figure.panel().labels("$x$", label);
    panel.curve(x, exact, exact_line());
    panel.points(x, value, {.label = "SPH", .marker = plot::Marker::circle, .marker_size = 4});
    run.save(figure);
}

void require_gamma_above_1(const Options& options) {
    if (!(options.gamma > 1))
        throw app::UsageError{"--gamma: 1 is not allowed in this scene; allowed: above 1"};
}

Spacing spacing_named(const std::string& name) {
    return name == "even" ? Spacing::even : name == "masses" ? Spacing::masses : Spacing::graded;
}

}  // namespace

void Options::declare(app::CommandLine& line) {
    line.choice("kernel", kernel, kernel_names(), "smoothing kernel of the scene")
        .number("h-over-dx", h_over_dx, {0.5, 8}, "spacings", "smoothing length: of all, or sigma of (4.2)")
        .number("gamma", gamma, {1, 100}, "", "adiabatic index; above 1 in scenes other than dispersion")
        .numbers("k-dx", k_dx, {0, 1000}, "1/spacing",
                 "wave numbers of the scene dispersion, a comma-separated list")
        .choice("resolution", resolution, resolution_names(), "where density and h come from")
        .choice("spacing", spacing, {"even", "graded", "masses"}, "of the particles of the scene star")
        .number("amplitude", amplitude, {0, 10}, "Omega", "A_0 of the scene star: v = A_0 x at t = 0")
        .integer("particles", particles, 8, 4096, "particles of the scene")
        .number("time", time, {0.01, 100}, "1/Omega", "how long the scene star runs");
}

void dispersion_scene(report::Run& run, const Options& options) {
    std::string csv = "k_dx,omega2_constant_h,omega2_variable_h\n";
    with_kernel<1>(options.kernel, [&](const auto& kernel) {
        for (const double k : options.k_dx) {
            const auto d = dispersion<std::decay_t<decltype(kernel)>>(options.h_over_dx, options.gamma, k);
            csv += report::csv_row({k, d.fixed_h, d.variable_h});
        }
    });
    run.print(csv);
}

void wave_scene(report::Run& run, const Options& options) {
    require_gamma_above_1(options);
    WaveScene scene;
    scene.n = static_cast<std::size_t>(options.particles);
    scene.gamma = options.gamma;
    scene.threads = run.threads();
    const WaveRun wave = run_wave(scene, scheme_of(options));
    run.result(options.resolution, options.particles, "l1_v", wave.error);
    run.result(options.resolution, options.particles, "momentum_drift", wave.momentum_drift);
    run.result(options.resolution, options.particles, "steps", static_cast<double>(wave.counters.steps));
    run.result(options.resolution, options.particles, "pairs", static_cast<double>(wave.counters.pairs));
    std::string csv = "x,v,exact_v\n";
    for (std::size_t i = 0; i < scene.n; ++i) csv += report::csv_row({wave.x[i], wave.v[i], wave.exact[i]});
    run.write("profile.csv", csv);
    draw(run, "wave", "$v$", wave.x, wave.v, wave.exact);
}

void star_scene(report::Run& run, const Options& options) {
    require_gamma_above_1(options);
    const auto& allowed = resolutions_at_rest();
    if (std::find(allowed.begin(), allowed.end(), options.resolution) == allowed.end())
        throw app::UsageError{"--resolution: " + options.resolution +
                              " is not allowed in this scene; allowed: fixed-h, without-omega, consistent-h"};
    if (options.particles > 1000)
        throw app::UsageError{"--particles: " + std::to_string(options.particles) +
                              " is not allowed in this scene; allowed: 8..1000"};
    StarScene scene;
    scene.n = static_cast<std::size_t>(options.particles);
    scene.gamma = options.gamma;
    scene.spacing = spacing_named(options.spacing);
    scene.threads = run.threads();
    const NonlinearRun star = run_nonlinear(scene, scheme_of(options), options.amplitude, options.time);
    run.result(options.resolution, options.particles, "radius_error", star.radius_error);
    if (options.amplitude > 0) run.result(options.resolution, options.particles, "l1_v", star.velocity_error);
    run.result(options.resolution, options.particles, "energy_drift", star.energy_drift);
    run.result(options.resolution, options.particles, "momentum_drift", star.momentum);
    run.result(options.resolution, options.particles, "steps", static_cast<double>(star.counters.steps));
    run.result(options.resolution, options.particles, "pairs", static_cast<double>(star.counters.pairs));
    std::string csv = "x,rho,v,exact_rho,exact_v\n";
    for (std::size_t i = 0; i < scene.n; ++i)
        csv += report::csv_row({star.x[i], star.rho[i], star.v[i], star.exact_rho[i], star.exact_v[i]});
    run.write("profile.csv", csv);
    draw(run, "star", "ρ", star.x, star.rho, star.exact_rho);
}

void rarefaction_scene(report::Run& run, const Options& options) {
    require_gamma_above_1(options);
    RarefactionScene scene;
    scene.n = static_cast<std::size_t>(options.particles);
    scene.gamma = options.gamma;
    scene.graded = options.spacing == "graded";
    scene.threads = run.threads();
    scene.time = 0.8 * 0.5 / std::sqrt(options.gamma * (options.gamma - 1) * scene.u);
    const RarefactionRun gas = run_rarefaction(scene, scheme_of(options));
    run.result(options.resolution, options.particles, "l1_v", gas.velocity_error);
    run.result(options.resolution, options.particles, "l1_rho", gas.density_error);
    run.result(options.resolution, options.particles, "energy_drift", gas.energy_drift);
    run.result(options.resolution, options.particles, "momentum_drift", gas.momentum);
    std::string csv = "x,v,rho,exact_v,exact_rho\n";
    for (std::size_t i = 0; i < scene.n; ++i)
        csv += report::csv_row({gas.x[i], gas.v[i], gas.rho[i], gas.exact_v[i], gas.exact_rho[i]});
    run.write("profile.csv", csv);
    draw(run, "rarefaction", "$v$", gas.x, gas.v, gas.exact_v);
}

}  // namespace sph::euler
