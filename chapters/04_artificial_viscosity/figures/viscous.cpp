#include <cmath>

#include "chapters/04_artificial_viscosity/figures/plane_style.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "chapters/04_artificial_viscosity/scenes/viscous_flow.hpp"
#include "common/exact/taylor_green.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

/// The rate of a decaying shear wave, nu = 0.01.
void shear_waves(report::Run& run, plot::Panel& panel, const std::vector<std::size_t>& sizes) {
    report::Table table{{"shear wave, ν = 0.01", "N", "rate / exact − 1 [%]", "CPU [s]"}};
    ShearScene scene;
    scene.nu = 0.01;
    scene.time = run.quick() ? 0.25 : 1;
    const auto add = [&](const std::string& name, const std::string& label, const ShearRun& wave) {
        const double error = wave.viscosity / scene.nu - 1;
        const auto n = static_cast<long>(scene.n * scene.n);
        run.result(name, n, "shear_rate_error", error);
        run.result(name, n, "shear_cpu_seconds", wave.seconds, "s");
        if (name != "grid") run.result(name, n, "shear_energy_drift", wave.energy_drift);
        table.row({label, report::fixed(static_cast<double>(n), 0), report::fixed(100 * error, 1),
                   report::timing(wave.seconds)});
        return std::max(1e-5, std::abs(error));
    };
    for (const std::string& name : {std::string{"pairwise"}, std::string{"stress"}, std::string{"grid"}}) {
        plot::Values n, error;
        for (const std::size_t size : sizes) {
            scene.n = size;
            n.push_back(static_cast<double>(size));
            const bool grid = name == "grid";
            const ShearRun wave = grid ? run_shear_grid(scene) : run_shear(scene, plane_method(name));
            error.push_back(add(name, grid ? "grid" : plane_method(name).label, wave));
        }
        panel.curve(n, error, name == "grid" ? grid_style() : plane_style(name));
    }
    run.fill("viscous-shear", table.markdown());
}

void draw_vortices(plot::Panel& panel, const VortexRun& run) {
    panel.labels("$x$", "$y$").x_range(0, 1).y_range(0, 1);
    panel.equal_aspect = true;
    plot::Discs discs{.name = "speed", .diameter = 4.5, .bar = {.label = "| $v$ | / $V$"}};
    for (std::size_t i = 0; i < run.x[0].size(); ++i) {
        const double x = run.x[0][i] - std::floor(run.x[0][i]), y = run.x[1][i] - std::floor(run.x[1][i]);
        discs.x.push_back(x);
        discs.y.push_back(y);
        discs.value.push_back(std::hypot(run.v[0][i], run.v[1][i]));
    }
    panel.particles(discs);
}

/// The decay of Taylor-Green vortices.
void vortices(report::Run& run, plot::Panel& map, plot::Panel& decay, plot::Panel& errors,
              const std::vector<std::size_t>& sizes) {
    report::Table table{{"vortices, Re = 20", "N", "rate / exact − 1 [%]", "v, L₂", "CPU [s]"}};
    VortexScene scene;
    if (run.quick()) scene.time = 0.05;
    const auto add = [&](const std::string& name, const std::string& label, const VortexRun& flow) {
        const auto n = static_cast<long>(flow.x[0].size());
        const double error = flow.decay_rate / flow.exact_rate - 1;
        run.result(name, n, "vortex_rate_error", error);
        run.result(name, n, "vortex_l2_v", flow.l2_v);
        run.result(name, n, "vortex_cpu_seconds", flow.seconds, "s");
        if (name != "grid") run.result(name, n, "vortex_energy_drift", flow.energy_drift);
        table.row({label, report::fixed(static_cast<double>(n), 0), report::fixed(100 * error, 0),
                   report::number(flow.l2_v, 1), report::timing(flow.seconds)});
    };
    for (const std::string& name : {std::string{"pairwise"}, std::string{"stress"}, std::string{"grid"}}) {
        plot::Values n, error;
        const bool grid = name == "grid";
        plot::Style style = grid ? grid_style() : plane_style(name);
        for (const std::size_t size : sizes) {
            scene.n = size;
            const VortexRun flow = grid ? run_vortex_grid(scene) : run_vortex(scene, plane_method(name));
            add(name, style.label, flow);
            n.push_back(static_cast<double>(size));
            error.push_back(flow.l2_v);
            if (size != sizes[1]) continue;
            plot::Values energy;
            for (const double value : flow.energy) energy.push_back(4 * value);
            decay.curve(flow.t, energy, style);
            if (name == "pairwise") draw_vortices(map, flow);
            if (!grid) continue;
            const exact::TaylorGreen exact{1 / scene.reynolds, 1, 1, 1};
            for (std::size_t s = 0; s < flow.t.size(); ++s) energy[s] = 4 * exact.kinetic_energy(flow.t[s]);
            plot::Style line = exact_line();
            line.layer = 0;
            decay.curve(flow.t, energy, line);
        }
        errors.curve(n, error, style);
    }
    run.fill("viscous-vortices", table.markdown());
}

}  // namespace

void viscous(report::Run& run) {
    plot::Figure figure{"viscous", 2, 2};
    plot::Panel& shear = figure.at(0, 0)
                             .log_log()
                             .titled("shear wave")
                             .labels("particles a side", "error of the decay's rate");
    plot::Panel& map = figure.at(0, 1).titled("Taylor–Green vortices, pairwise");
    plot::Panel& decay = figure.at(1, 0).log_y().labels("$t$ $V$ / $L$", "kinetic energy / first");
    plot::Panel& errors =
        figure.at(1, 1).log_log().labels("particles a side", "relative $L$_{2} error of $v$");
    const std::vector<std::size_t> sizes =
        run.quick() ? std::vector<std::size_t>{12, 16} : std::vector<std::size_t>{16, 32, 48};
    shear_waves(run, shear, sizes);
    vortices(run, map, decay, errors, sizes);
    for (plot::Panel* panel : {&shear, &errors}) panel->x.ticks.assign(sizes.begin(), sizes.end());
    decay.legend.shown = errors.legend.shown = false;
    run.save(figure);
}

}  // namespace sph::shocks
