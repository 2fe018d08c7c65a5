#include <cmath>
#include <map>

#include "chapters/04_artificial_viscosity/figures/plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "chapters/04_artificial_viscosity/scenes/viscous_flow.hpp"
#include "common/exact/taylor_green.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/norms.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

/// A contestant: a method, or the grid.
template <class Scene, class Result>
struct Contestant {
    std::string name;
    plot::Style look;
    std::function<Result(const Scene&)> run;
};
template <class Scene, class Result, class OfMethod, class OfGrid>
std::vector<Contestant<Scene, Result>> contestants(OfMethod of_method, OfGrid of_grid) {
    std::vector<Contestant<Scene, Result>> all;
    for (const Method<2>& method : viscous_methods())
        all.push_back({method.name, method.styled(),
                       [of_method, method](const Scene& scene) { return of_method(scene, method); }});
    all.push_back({"grid", plot::competitor("grid"), of_grid});
    return all;
}

/// The rate of a decaying shear wave, nu = 0.01.
void shear_waves(report::Run& run, plot::Panel& panel, const std::vector<std::size_t>& sizes) {
    using namespace report;
    Comparison table{{"shear wave, ν = 0.01", "N"},
                     {{"rate / exact − 1 [%]", "shear_rate_error", decimals(1, 100)},
                      {"CPU [s]", "shear_cpu_seconds", time_in(1)}}};
    std::map<std::string, plot::Values> errors;
    ShearScene scene;
    scene.nu = 0.01;
    scene.time = run.quick() ? 0.25 : 1;
    for (const auto& who : contestants<ShearScene, ShearRun>(run_shear, run_shear_grid)) {
        plot::Values error;
        for (const std::size_t size : sizes) {
            scene.n = size;
            const ShearRun wave = who.run(scene);
            const double rate_error = wave.viscosity / scene.nu - 1;
            Quantities measured{{"shear_rate_error", rate_error}, {"shear_cpu_seconds", wave.seconds, "s"}};
            if (who.name != "grid") measured.push_back({"shear_energy_drift", wave.energy_drift});
            const std::size_t n = size * size;
            table.add(run, who.name, n, {who.look.label, std::to_string(n)}, measured);
            error.push_back(std::max(1e-5, std::abs(rate_error)));
        }
        panel.curve({sizes.begin(), sizes.end()}, error, who.look);
        errors[who.name] = error;
    }
    run.fill("viscous-shear", table.markdown());
    run.claim("stress-converges", [&] {
        const auto &pairwise = errors.at("pairwise"), &stress = errors.at("stress");
        const double order = report::observed_order(static_cast<double>(sizes.front()), stress.front(),
                                                    static_cast<double>(sizes.back()), stress.back());
        return order > 1.6 && pairwise.back() > 0.02 && pairwise.back() < 0.035;
    });
}

void draw_vortices(plot::Panel& panel, const VortexRun& run) {
    panel.labels("$x$", "$y$").x_range(0, 1).y_range(0, 1);
    panel.equal_aspect = true;
    plot::Discs discs{.name = "speed", .diameter = 4.5, .bar = {.label = "| $v$ | / $V$"}};
    for (std::size_t i = 0; i < run.x[0].size(); ++i) {
        discs.x.push_back(run.x[0][i] - std::floor(run.x[0][i]));
        discs.y.push_back(run.x[1][i] - std::floor(run.x[1][i]));
        discs.value.push_back(std::hypot(run.v[0][i], run.v[1][i]));
    }
    panel.particles(discs);
}

/// The kinetic energy over the exact one.
plot::Values over_exact(const VortexRun& flow, const exact::TaylorGreen& exact) {
    plot::Values ratio;
    for (std::size_t k = 0; k < flow.t.size(); ++k)
        ratio.push_back(flow.energy[k] / exact.kinetic_energy(flow.t[k]));
    return ratio;
}
/// The decay of Taylor-Green vortices.
void vortices(report::Run& run, plot::Panel& map, plot::Panel& decay, plot::Panel& errors,
              const std::vector<std::size_t>& sizes) {
    using namespace report;
    Comparison table{{"vortices, Re = 20", "N"},
                     {{"rate / exact − 1 [%]", "vortex_rate_error", decimals(0, 100)},
                      {"v, L₂", "vortex_l2_v", digits(1)},
                      {"CPU [s]", "vortex_cpu_seconds", time_in(1)}}};
    std::map<std::string, plot::Values> rates;
    std::map<std::string, double> last;
    VortexScene scene;
    if (run.quick()) scene.time = 0.05;
    for (const auto& who : contestants<VortexScene, VortexRun>(run_vortex, run_vortex_grid)) {
        plot::Values error;
        for (const std::size_t size : sizes) {
            scene.n = size;
            const VortexRun flow = who.run(scene);
            const std::size_t n = flow.x[0].size();
            Quantities measured{{"vortex_rate_error", flow.decay_rate / flow.exact_rate - 1},
                                {"vortex_l2_v", flow.l2_v},
                                {"vortex_cpu_seconds", flow.seconds, "s"}};
            if (who.name != "grid") measured.push_back({"vortex_energy_drift", flow.energy_drift});
            table.add(run, who.name, n, {who.look.label, std::to_string(n)}, measured);
            error.push_back(flow.l2_v);
            rates[who.name].push_back(flow.decay_rate / flow.exact_rate - 1);
            if (size != sizes[1]) continue;
            decay.curve(flow.t, over_exact(flow, {1 / scene.reynolds, 1, 1, 1}), who.look);
            if (who.name == "pairwise") draw_vortices(map, flow);
        }
        errors.curve({sizes.begin(), sizes.end()}, error, who.look);
        last[who.name] = error.back();
    }
    run.fill("viscous-vortices", table.markdown());
    run.claim("vortices-hard", [&] {
        const auto rough = [](double error) { return error > 0.08 && error < 0.25; };
        const auto near = [](double rate) { return std::abs(rate) < 0.08; };
        return rough(last.at("pairwise")) && rough(last.at("stress")) && last.at("grid") < 0.015 &&
               near(rates.at("pairwise")[1]) && near(rates.at("pairwise")[2]) &&
               near(rates.at("stress")[1]) && near(rates.at("stress")[2]);
    });
}

}  // namespace

void viscous(report::Run& run) {
    plot::Figure figure{"viscous", 2, 2};
    plot::Panel& shear = figure.at(0, 0)
                             .log_log()
                             .titled("shear wave")
                             .labels("particles a side", "error of the decay's rate");
    plot::Panel& map = figure.at(0, 1).titled("Taylor–Green vortices, pairwise");
    plot::Panel& decay = figure.at(1, 0).labels("$t$ $V$ / $L$", "kinetic energy / exact");
    plot::Panel& errors =
        figure.at(1, 1).log_log().labels("particles a side", "relative $L$_{2} error of $v$");
    const auto sizes = run.sizes({12, 16}, {16, 32, 48});
    shear_waves(run, shear, sizes);
    vortices(run, map, decay, errors, sizes);
    decay.curve({0, run.quick() ? 0.05 : 0.25}, {1, 1}, plot::exact());
    for (plot::Panel* panel : {&shear, &errors}) panel->x.ticks.assign(sizes.begin(), sizes.end());
    decay.legend.shown = errors.legend.shown = false;
    run.save(figure);
}

}  // namespace sph::shocks
