#include "chapters/04_artificial_viscosity/figures/tubes.hpp"

#include <algorithm>

#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::shocks {
namespace {

void draw(report::Run& run, const TubeFigure& what, const TubeRuns& tubes) {
    plot::Figure figure{what.name, 2, 2};
    const Profile exact = exact_profile(what.scene, what.low, what.high);
    const auto panel = [&](int row, int column, const std::string& label, Column Profile::*quantity) {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label).x_range(what.low, what.high);
        for (const auto& [method, tube] : tubes) {
            if (std::find(what.drawn.begin(), what.drawn.end(), method.name) == what.drawn.end()) continue;
            axes.points(tube.profile.x, tube.profile.*quantity, plot::dots(method.styled()));
        }
        axes.curve(exact.x, exact.*quantity, plot::exact());
        axes.legend.shown = row == 0 && column == 1;
        axes.legend.outside = true;
    };
    panel(0, 0, "ρ", &Profile::rho);
    panel(0, 1, "$v$", &Profile::v);
    panel(1, 0, "$P$", &Profile::p);
    panel(1, 1, "$u$", &Profile::u);
    run.save(figure);
}

std::vector<report::Shows> columns(bool with_u) {
    using namespace report;
    std::vector<Shows> all{
        {"ρ %", "l1_rho", in_percent()}, {"v %", "l1_v", in_percent()}, {"P %", "l1_p", in_percent()}};
    if (with_u) all.push_back({"u %", "l1_u", in_percent()});
    all.push_back({"overshoot %", "overshoot_rho", in_percent()});
    all.push_back({"spike of P %", "wiggle_p", in_percent()});
    all.push_back({"steps", "steps", whole()});
    all.push_back({"CPU ms", "cpu_seconds", time_in(1e-3)});
    return all;
}

/// Some methods over several N.
void over_sizes(report::Run& run, const TubeFigure& what) {
    report::Comparison table{{"method", "N"}, columns(false)};
    for (const Method<1>& method : tube_methods().named(what.compared)) {
        for (const std::size_t n : what.sizes) {
            TubeScene scene = what.scene;
            scene.n = n;
            const TubeRun tube = run_tube(scene, method);
            table.add(run, method.name + " series", n, {method.label, std::to_string(n)},
                      tube.errors() + tube.costs());
        }
    }
    run.fill(what.block, table.markdown());
}

}  // namespace

TubeRuns tube_tables(report::Run& run, TubeFigure what, std::size_t quick_n) {
    if (run.quick()) what.scene.n = quick_n;
    what.scene.threads = run.threads();
    const std::size_t n = what.scene.n;
    report::Comparison table{{"method"}, columns(true)};
    TubeRuns runs;
    std::vector<Method<1>> methods = tube_contestants();
    for (const Method<1>& method : tube_methods().named(what.more)) methods.push_back(method);
    for (const Method<1>& method : methods) {
        const TubeRun tube = run_tube(what.scene, method);
        table.add(run, method.name, n, {method.label}, tube.errors() + tube.drifts() + tube.costs());
        runs.emplace_back(method, tube);
    }
    for (const Grid& grid : grids()) {
        const TubeRun tube = run_grid_tube(what.scene, grid.frame);
        table.add(run, grid.name, n, {grid.label}, tube.errors() + tube.costs());
    }
    run.fill(what.name, table.markdown());
    if (!run.quick()) over_sizes(run, what);
    return runs;
}

TubeRuns tube_figure(report::Run& run, TubeFigure what, std::size_t quick_n) {
    TubeRuns runs = tube_tables(run, what, quick_n);
    draw(run, what, runs);
    return runs;
}

const TubeRun& run_of(const TubeRuns& runs, const std::string& name) {
    return std::find_if(runs.begin(), runs.end(), [&](const auto& one) { return one.first.name == name; })
        ->second;
}

}  // namespace sph::shocks
