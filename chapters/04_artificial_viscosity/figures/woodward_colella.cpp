#include "common/exact/woodward_colella.hpp"

#include <map>

#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::shocks {
namespace {

void draw_reference(plot::Panel& rho, plot::Panel& v) {
    Column x, density, velocity;
    const exact::WoodwardColella reference;
    for (const auto& node : reference.nodes()) {
        x.push_back(node.x);
        density.push_back(node.rho);
        velocity.push_back(node.v);
    }
    rho.curve(x, density, plot::exact("reference"));
    v.curve(x, velocity, plot::exact("reference"));
}

}  // namespace

void woodward_colella(report::Run& run) {
    BlastWaves scene;
    scene.n = run.quick() ? 100 : 400;
    scene.threads = run.threads();
    plot::Figure figure{"woodward-colella", 1, 2};
    plot::Panel& rho = figure.at(0, 0).labels("$x$", "ρ").x_range(0.5, 0.9);
    plot::Panel& v = figure.at(0, 1).labels("$x$", "$v$").x_range(0.5, 0.9);
    draw_reference(rho, v);
    using namespace report;
    Comparison table{{"method"},
                     {{"ρ %", "l1_rho", in_percent()},
                      {"v %", "l1_v", in_percent()},
                      {"P %", "l1_p", in_percent()},
                      {"energy drift", "energy_drift", or_word(1e-12, "rounding", digits(1))},
                      {"steps", "steps", digits(2)},
                      {"CPU ms", "cpu_seconds", time_in(1e-3)}}};
    const auto measured = [](const TubeRun& tube) {
        return Quantities{{"l1_rho", tube.l1_rho},
                          {"l1_v", tube.l1_v},
                          {"l1_p", tube.l1_p},
                          {"energy_drift", tube.energy_drift}} +
               tube.costs();
    };
    std::map<std::string, double> error;
    for (const Method<1>& method : tube_methods().named({"signal", "price", "narrow", "reconstructed"})) {
        const TubeRun tube = run_blast_waves(scene, method);
        table.add(run, method.name, scene.n, {method.label}, measured(tube));
        error[method.name] = tube.l1_rho;
        if (method.name != "narrow" && method.name != "reconstructed") continue;
        rho.points(tube.profile.x, tube.profile.rho, plot::dots(method.styled()));
        v.points(tube.profile.x, tube.profile.v, plot::dots(method.styled()));
    }
    for (const Grid& grid : grids()) {
        const TubeRun tube = run_grid_blast_waves(scene, grid.frame);
        table.add(run, grid.name, scene.n, {grid.label}, measured(tube));
        error[grid.name] = tube.l1_rho;
    }
    run.claim("wc-conduction", [&] {
        return error["signal"] < error["grid"] / 2.5 && error["narrow"] < error["grid"] / 2.5 &&
               error["price"] > 2 * error["signal"] && error["grid-lagrangian"] < error["narrow"];
    });
    rho.legend.shown = false;
    v.legend.outside = true;
    run.save(figure);
    run.fill("woodward-colella", table.markdown());
}

}  // namespace sph::shocks
