#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/figures/figures.hpp"

/// Sod's tube, the tube at Mach 1.526, and the blast: every method, beside the grid.
namespace sph::shocks {
namespace {

/// Percent with two digits.
std::string percent(double value) {
    return report::number(100 * value, 2);
}

void rows_of(report::Run& run, const std::string& method, long n, const TubeRun& tube) {
    run.result(method, n, "l1_rho", tube.l1_rho);
    run.result(method, n, "l1_v", tube.l1_v);
    run.result(method, n, "l1_p", tube.l1_p);
    run.result(method, n, "l1_u", tube.l1_u);
    run.result(method, n, "overshoot_rho", tube.overshoot);
    run.result(method, n, "wiggle_p", tube.wiggle);
    run.result(method, n, "steps", static_cast<double>(tube.counters.steps));
    run.result(method, n, "cpu_seconds", tube.seconds, "s");
}

struct Grid {
    std::string name, label;
    exact::Frame frame;
};
const std::vector<Grid>& grids() {
    static const std::vector<Grid> all{{"grid", "grid, Eulerian", exact::Frame::eulerian},
                                       {"grid-lagrangian", "grid, Lagrangian", exact::Frame::lagrangian}};
    return all;
}

struct Study {
    std::string name;  ///< of figure and table
    TubeScene scene;
    std::vector<std::string> methods, drawn;
    double low = -0.5, high = 0.5;  ///< of x in the figure
};

void draw(report::Run& run, const Study& study, const std::vector<std::pair<std::string, TubeRun>>& tubes) {
    plot::Figure figure{study.name, 2, 2};
    const Profile exact = exact_profile(study.scene, study.low, study.high);
    const auto panel = [&](int row, int column, const std::string& label, Column Profile::*quantity) {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label).x_range(study.low, study.high);
        axes.curve(exact.x, exact.*quantity, exact_line());
        for (const auto& [method, tube] : tubes) {
            if (std::find(study.drawn.begin(), study.drawn.end(), method) == study.drawn.end()) continue;
            axes.points(tube.profile.x, tube.profile.*quantity, dots(style_of(method)));
        }
        axes.legend.shown = row == 0 && column == 1;
        axes.legend.outside = true;
    };
    panel(0, 0, "ρ", &Profile::rho);
    panel(0, 1, "$v$", &Profile::v);
    panel(1, 0, "$P$", &Profile::p);
    panel(1, 1, "$u$", &Profile::u);
    run.save(figure);
}

void tubes(report::Run& run, const Study& study) {
    report::Table table{
        {"method", "ρ %", "v %", "P %", "u %", "overshoot %", "wiggle of P %", "steps", "CPU ms"}};
    std::vector<std::pair<std::string, TubeRun>> runs;
    const auto n = static_cast<long>(study.scene.n);
    const auto row = [&](const std::string& name, const std::string& label, const TubeRun& tube) {
        rows_of(run, name, n, tube);
        table.row({label, percent(tube.l1_rho), percent(tube.l1_v), percent(tube.l1_p), percent(tube.l1_u),
                   percent(tube.overshoot), percent(tube.wiggle), std::to_string(tube.counters.steps),
                   report::timing(1e3 * tube.seconds)});
    };
    for (const Method& method : methods_named(study.methods)) {
        runs.emplace_back(method.name, run_tube(study.scene, method));
        run.result(method.name, n, "energy_drift", runs.back().second.energy_drift);
        run.result(method.name, n, "momentum_drift", runs.back().second.momentum_drift);
        row(method.name, method.label, runs.back().second);
    }
    for (const Grid& grid : grids()) row(grid.name, grid.label, run_grid_tube(study.scene, grid.frame));
    draw(run, study, runs);
    run.fill(study.name, table.markdown());
}

/// The best method and a second one over several N: errors in percent, the wiggle, the overshoot.
void convergence(report::Run& run, const TubeScene& given, const std::vector<std::size_t>& sizes,
                 const std::vector<std::string>& methods, const std::string& block) {
    report::Table table{
        {"method", "N", "ρ %", "v %", "P %", "overshoot %", "wiggle of P %", "steps", "CPU ms"}};
    for (const Method& method : methods_named(methods)) {
        for (const std::size_t n : sizes) {
            TubeScene scene = given;
            scene.n = n;
            const TubeRun tube = run_tube(scene, method);
            rows_of(run, method.name + " series", static_cast<long>(n), tube);
            table.row({method.label, std::to_string(n), percent(tube.l1_rho), percent(tube.l1_v),
                       percent(tube.l1_p), percent(tube.overshoot), percent(tube.wiggle),
                       std::to_string(tube.counters.steps), report::timing(1e3 * tube.seconds)});
        }
    }
    run.fill(block, table.markdown());
}

const std::vector<std::string> all_methods{"von-neumann", "bulk",          "monaghan-gingold", "alpha-beta",
                                           "signal",      "thermokinetic", "morris-monaghan",  "price",
                                           "narrow",      "reconstructed"};

}  // namespace

void sod(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 720;
    scene.threads = run.threads();
    tubes(run, {"sod", scene, all_methods, {"thermokinetic", "reconstructed"}});
    if (run.quick()) return;
    convergence(run, scene, {180, 360, 720, 900}, {"signal", "reconstructed"}, "sod-series");
}

void mach(report::Run& run) {
    TubeScene scene;
    scene.right = {0.5, 0, 0.2};
    scene.n = run.quick() ? 60 : 120;
    scene.threads = run.threads();
    tubes(run, {"mach", scene, all_methods, {"signal", "reconstructed"}});
    if (run.quick()) return;
    convergence(run, scene, {120, 240, 480}, {"signal", "reconstructed"}, "mach-series");
}

void blast(report::Run& run) {
    TubeScene scene{{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006};
    scene.n = run.quick() ? 60 : 200;
    scene.threads = run.threads();
    tubes(run, {"blast", scene, all_methods, {"signal", "reconstructed"}, 0.1, 0.3});
    if (run.quick()) return;
    convergence(run, scene, {200, 400}, {"signal", "price", "narrow", "reconstructed"}, "blast-series");
}

}  // namespace sph::shocks
