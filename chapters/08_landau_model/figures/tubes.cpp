#include "chapters/08_landau_model/figures/tubes.hpp"

#include <algorithm>

#include "chapters/08_landau_model/scenes/grid.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::landau {
namespace {

struct Entry {
    std::string name, label;
    plot::Style look;
    std::size_t n;  ///< its own: some runs have half the scene's
    TubeRun run;
    bool drawn = true, noisy = false;
};

std::vector<Entry> entries(const TubeFigure& what) {
    TubeScene half = what.scene;
    half.n /= 2;
    const TubeMethod &classical = relativistic_methods()["chow-monaghan"],
                     &best = relativistic_methods().recommended();
    const TubeScene& for_classical = what.classical_has_half ? half : what.scene;
    std::vector<Entry> all;
    all.push_back({classical.name, classical.label, classical.look, for_classical.n,
                   run_relativistic_tube(for_classical, classical), true, what.classical_has_half});
    all.push_back({best.name, best.label, best.look, what.scene.n, run_relativistic_tube(what.scene, best)});
    half.jitter = 0.1;  // not drawn: it lies on the even one
    all.push_back({best.name + " jitter=0.1", best.label + ", jitter 0.1", best.look, half.n,
                   run_relativistic_tube(half, best), false});
    all.push_back(
        {"grid", "grid", plot::competitor("grid"), what.scene.n, run_grid_relativistic_tube(what.scene)});
    return all;
}

void draw(report::Run& run, const TubeFigure& what, const std::vector<Entry>& all) {
    using shocks::Profile;
    const Profile exact = shocks::exact_profile(exact_relativistic_tube(what.scene), what.low, what.high);
    plot::Figure figure{what.name, 2, 2};
    const auto panel = [&](int row, int column, const std::string& label,
                           Column Profile::*quantity) -> plot::Panel& {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label).x_range(what.low, what.high);
        for (auto entry = all.rbegin(); entry != all.rend(); ++entry) {  // the grid below the particles
            if (!entry->drawn) continue;
            plot::Style look = plot::dots(entry->look, 3);
            look.label = entry->label;
            if (entry->n != what.scene.n) look.label += ", $N$ = " + std::to_string(entry->n);
            axes.points(entry->run.profile.x, entry->run.profile.*quantity, look);
        }
        axes.curve(exact.x, exact.*quantity, plot::exact());
        axes.legend.shown = row == 0 && column == 1;
        axes.legend.outside = true;
        return axes;
    };
    panel(0, 0, "ρ", &Profile::rho);
    panel(0, 1, "$v$", &Profile::v);
    panel(1, 0, "$P$", &Profile::p);
    panel(1, 1, "$u$", &Profile::u).log_y();
    run.save(figure);
}

}  // namespace

std::map<std::string, report::Quantities> tube_figure(report::Run& run, TubeFigure what) {
    if (run.quick()) what.scene.n = 100;
    const std::vector<Entry> all = entries(what);
    draw(run, what, all);
    using namespace report;
    Comparison table{
        {"method", "N"},
        {{"ρ %", "l1_rho", in_percent()},
         {"v %", "l1_v", in_percent()},
         {"P %", "l1_p", in_percent()},
         {"shock %", "shock_error", in_percent()},
         {"peak of ρ, exact = 1", "shell_peak", decimals(2)},
         {"energy drift", "energy_drift", [](double drift) { return below(std::max(drift, 1e-13)); }},
         {"steps", "steps", whole()},
         {"CPU s", "cpu_seconds", time_in(1)}}};
    std::map<std::string, Quantities> errors_of;
    for (const Entry& entry : all) {
        const TubeRun& tube = entry.run;
        const Shock shock = shock_of(tube, what.scene).value_or(nowhere);
        const Quantities& errors = errors_of[entry.name] = {{"l1_rho", tube.l1_rho},
                                                            {"l1_v", tube.l1_v},
                                                            {"l1_p", tube.l1_p},
                                                            {"shock_error", shock.error},
                                                            {"shell_peak", shock.peak}};
        table.add(run, entry.name, entry.n, {entry.label, std::to_string(entry.n)},
                  errors + tube.drifts() + tube.costs(), entry.noisy ? Digits::noisy : Digits::stable);
    }
    run.fill(what.name, table.markdown());
    return errors_of;
}

}  // namespace sph::landau
