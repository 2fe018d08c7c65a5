#include <cmath>

#include "chapters/08_landau_model/scenes/grid.hpp"
#include "chapters/08_landau_model/figures/figures.hpp"

/// Marti & Mueller's blasts and the collision, by both dissipations and the grid.
namespace sph::landau {
namespace {

struct Study {
    std::string name;
    TubeScene scene;
    double low, high;  ///< of x in the figure
    bool classical_has_half =
        false;  ///< the classical dissipation: half the particles, an eighth of the time
};

std::string percent(double value) {
    return report::number(100 * value, 2);
}

void tube(report::Run& run, const Study& study) {
    struct Entry {
        std::string name, label;
        std::size_t n;  ///< its own: some runs have half the scene's
        RelativisticTubeRun result;
    };
    std::vector<Entry> entries;
    TubeScene half = study.scene;
    half.n /= 2;
    const Method &classical = relativistic_method("chow-monaghan"), &best = relativistic_methods().back();
    const TubeScene& for_classical = study.classical_has_half ? half : study.scene;
    entries.push_back(
        {classical.name, classical.label, for_classical.n, run_relativistic_tube(for_classical, classical)});
    entries.push_back({best.name, best.label, study.scene.n, run_relativistic_tube(study.scene, best)});
    half.jitter = 0.1;
    entries.push_back(
        {best.name + " jitter=0.1", best.label + ", jitter 0.1", half.n, run_relativistic_tube(half, best)});
    entries.push_back({"grid", "grid", study.scene.n, run_grid_relativistic_tube(study.scene)});
    report::Table table{{"method", "N", "ρ %", "v %", "P %", "shock %", "peak of ρ, exact = 1",
                         "energy drift", "steps", "CPU s"}};
    const Profile exact = exact_profile(exact_tube(relativistic_solution(study.scene), study.scene.time),
                                        study.low, study.high);
    plot::Figure figure{study.name, 2, 2};
    const auto panel = [&](int row, int column, const std::string& label,
                           Column Profile::*quantity) -> plot::Panel& {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label).x_range(study.low, study.high);
        axes.curve(exact.x, exact.*quantity, exact_line());
        // The grid below the particles; not the disordered run, which lies on the even one.
        for (const std::size_t k : {std::size_t{3}, std::size_t{0}, std::size_t{1}}) {
            axes.points(
                entries[k].result.profile.x, entries[k].result.profile.*quantity,
                {.label = entries[k].label +
                          (entries[k].n == study.scene.n ? "" : ", $N$ = " + std::to_string(entries[k].n)),
                 .colour = k == 3 ? plot::Colour{0.5, 0.5, 0.5} : plot::cycle(k),
                 .marker = k == 3 ? plot::Marker::plus : plot::Marker::circle,
                 .marker_size = 3});
        }
        axes.legend.shown = row == 0 && column == 1;
        axes.legend.outside = true;
        return axes;
    };
    panel(0, 0, "ρ", &Profile::rho);
    panel(0, 1, "$v$", &Profile::v);
    panel(1, 0, "$P$", &Profile::p);
    panel(1, 1, "$u$", &Profile::u).log_y();
    run.save(figure);
    for (const Entry& entry : entries) {
        const RelativisticTubeRun& result = entry.result;
        const auto n = static_cast<long>(entry.n);
        const auto row = [&](const std::string& quantity, double value) {
            run.result(entry.name, n, quantity, value);
        };
        row("l1_rho", result.l1_rho), row("l1_v", result.l1_v), row("l1_p", result.l1_p);
        row("shock_error", result.shock_error), row("shell_peak", result.shell_peak);
        row("energy_drift", result.energy_drift), row("momentum_drift", result.momentum_drift);
        row("steps", static_cast<double>(result.counters.steps));
        run.result(entry.name, n, "cpu_seconds", result.seconds, "s");
        table.row({entry.label, std::to_string(n), percent(result.l1_rho), percent(result.l1_v),
                   percent(result.l1_p), percent(result.shock_error), report::fixed(result.shell_peak, 2),
                   below(std::max(result.energy_drift, 1e-13)), std::to_string(result.counters.steps),
                   report::timing(result.seconds)});
    }
    run.fill(study.name, table.markdown());
}

TubeScene sized(report::Run& run, TubeScene scene, std::size_t n) {
    scene.n = run.quick() ? 100 : n;
    return scene;
}

}  // namespace

void problem_1(report::Run& run) {
    tube(run, {"problem-1", sized(run, problem(1), 1000), -0.5, 0.5});
}
void problem_2(report::Run& run) {
    tube(run, {"problem-2", sized(run, problem(2), 1000), 0.3, 0.37, true});
}
void collision(report::Run& run) {
    tube(run, {"collision", sized(run, streams(), 400), -0.3, 0.3});
}

}  // namespace sph::landau
