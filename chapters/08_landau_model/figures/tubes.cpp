#include "chapters/08_landau_model/figures/tubes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "chapters/08_landau_model/scenes/grid.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::landau {
namespace {

TubeEntries entries(const TubeFigure& what) {
    TubeScene half = what.scene;
    half.n /= 2;
    half.jitter = 0.1;
    const TubeMethod &classical = relativistic_methods()["chow-monaghan"],
                     &best = relativistic_methods().recommended();
    const std::size_t n = what.scene.n;
    TubeEntries all;
    all.push_back({classical.name,
                   classical.label,
                   classical.look,
                   n,
                   run_relativistic_tube(what.scene, classical),
                   {},
                   true,
                   what.classical_is_noisy});
    all.push_back({best.name, best.label, best.look, n, run_relativistic_tube(what.scene, best)});
    all.push_back({best.name + " jitter=0.1",
                   best.label + ", jitter 0.1",
                   best.look,
                   half.n,
                   run_relativistic_tube(half, best),
                   {},
                   false});
    all.push_back({"grid", "grid", plot::competitor("grid"), n, run_grid_relativistic_tube(what.scene)});
    for (TubeEntry& one : all) one.shock = shock_of(one.run, what.scene).value_or(nowhere);
    return all;
}

/// The entry's markers in the panel, those left out that lie on the last one drawn, or a cloud hides what it
/// should be compared with.
void draw_markers(plot::Panel& axes, const TubePanel& panel, const TubeEntry& entry) {
    constexpr double apart = 1.0 / 70;  // of the panel
    const auto& profile = entry.run.profile;
    const Column& all = profile.*panel.quantity;
    const auto inside = [&](double x) { return x >= panel.low && x <= panel.high; };
    const auto height = [&](double y) { return panel.log_y ? std::log(y) : y; };
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!inside(profile.x[i])) continue;
        least = std::min(least, height(all[i])), most = std::max(most, height(all[i]));
    }
    plot::Values x, y;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!inside(profile.x[i])) continue;
        const bool far = x.empty() || std::abs(profile.x[i] - x.back()) > apart * (panel.high - panel.low) ||
                         std::abs(height(all[i]) - height(y.back())) > 2 * apart * (most - least);
        if (far) x.push_back(profile.x[i]), y.push_back(all[i]);
    }
    plot::Style look = plot::dots(entry.look, 4);
    look.label = entry.label;
    axes.points(x, y, look);
}

void draw(report::Run& run, const TubeFigure& what, const TubeEntries& all) {
    plot::Figure figure{what.name, 2, 2};
    for (std::size_t k = 0; k < what.panels.size(); ++k) {
        const TubePanel& panel = what.panels[k];
        const shocks::Profile exact =
            shocks::exact_profile(exact_relativistic_tube(what.scene), panel.low, panel.high);
        plot::Panel& axes = figure.at(static_cast<int>(k / 2), static_cast<int>(k % 2)).titled(panel.title);
        axes.labels("$x$", panel.label).x_range(panel.low, panel.high);
        if (panel.log_y) axes.log_y();
        for (auto entry = all.rbegin(); entry != all.rend(); ++entry) {  // the grid below the particles
            if (entry->drawn) draw_markers(axes, panel, *entry);
        }
        axes.curve(exact.x, exact.*panel.quantity, plot::exact());
        axes.legend.shown = k == 0;
    }
    run.save(figure);
}

}  // namespace

report::Quantities TubeEntry::errors() const {
    return {{"l1_rho", run.l1_rho},
            {"l1_v", run.l1_v},
            {"l1_p", run.l1_p},
            {"shock_error", shock.error},
            {"shell_peak", shock.peak}};
}

const TubeEntry& entry_of(const TubeEntries& entries, const std::string& name) {
    for (const TubeEntry& one : entries) {
        if (one.name == name) return one;
    }
    throw std::out_of_range{"no run of " + name};
}

TubeEntries tube_figure(report::Run& run, TubeFigure what) {
    if (run.quick()) what.scene.n = 100;
    TubeEntries all = entries(what);
    draw(run, what, all);
    using namespace report;
    const std::vector<Shows> errors{{"ρ %", "l1_rho", in_percent()},
                                    {"v %", "l1_v", in_percent()},
                                    {"P %", "l1_p", in_percent()},
                                    {"shock %", "shock_error", in_percent()}};
    const Shows time{"CPU s", "cpu_seconds", time_in(1)};
    std::vector<Shows> columns = errors, few = errors;
    few.push_back(time);
    columns.push_back({"peak of ρ, exact = 1", "shell_peak", decimals(2)});
    columns.push_back(
        {"energy drift", "energy_drift", [](double drift) { return below(std::max(drift, 1e-13)); }});
    columns.push_back({"steps", "steps", whole()});
    columns.push_back(time);
    Comparison table{{"method", "N"}, columns}, story{{"method"}, few};
    for (const TubeEntry& entry : all) {
        const Quantities measured = entry.errors() + entry.run.drifts() + entry.run.costs();
        const Digits shown = entry.noisy ? Digits::noisy : Digits::stable;
        table.add(run, entry.name, entry.n, {entry.label, std::to_string(entry.n)}, measured, shown);
        if (entry.drawn) story.show({entry.label}, measured, shown);
    }
    run.fill(what.name, table.markdown());
    if (what.with_story) run.fill(what.name + "-story", story.markdown());
    return all;
}

}  // namespace sph::landau
