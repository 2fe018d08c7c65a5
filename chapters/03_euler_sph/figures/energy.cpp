#include <algorithm>
#include <map>

#include "chapters/03_euler_sph/scenes/star_energy.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

/// The energy of a star that oscillates for long.
namespace sph::euler {
namespace {

/// What an integrator did with each time step.
struct Line {
    plot::Values amplitude, drift, shadow;
};
using Lines = std::map<std::string, Line>;

std::size_t colour_of(const std::string& name) {
    return name == "kick-drift-kick" ? 0 : name == "RK4" ? 2 : name == "naive steps" ? 1 : 3;
}

void draw_time(plot::Panel& panel, const std::string& name, const EnergyHistory& history) {
    if (name != "kick-drift-kick" && name != "naive steps" && name != "RK4") return;
    plot::Values change;
    for (const double value : history.change) change.push_back(1e6 * value);
    panel.curve(
        history.t, change,
        {.label = name, .colour = plot::cycle(colour_of(name)), .width = 1, .layer = name == "RK4" ? 2 : 1});
}

void draw_steps(plot::Panel& panel, const Column& courants, const Lines& lines) {
    using plot::Dash, plot::Marker;
    const auto draw = [&](const std::string& name, const plot::Values& values, const std::string& what,
                          Dash dash, Marker marker) {
        panel.curve(
            courants, values,
            {.label = name + what, .colour = plot::cycle(colour_of(name)), .dash = dash, .marker = marker});
    };
    const Line& leapfrog = lines.at("kick-drift-kick");
    draw("kick-drift-kick", leapfrog.amplitude, ": amplitude", Dash::solid, Marker::circle);
    draw("kick-drift-kick", leapfrog.drift, ": drift", Dash::dashed, Marker::circle);
    draw("kick-drift-kick", leapfrog.shadow, ": amplitude of (3.29)", Dash::solid, Marker::diamond);
    draw("naive steps", lines.at("naive steps").drift, ": drift", Dash::dashed, Marker::square);
    draw("RK4", lines.at("RK4").drift, ": drift", Dash::dashed, Marker::triangle_up);
    panel.slope(2, 0.25, 0.5, 2.5e-6, "order 2");
    panel.slope(4, 0.4, 0.8, 1.2e-10, "order 4");
}

void claims(report::Run& run, const Column& courants, const Lines& lines) {
    const auto order = [&](const plot::Values& values) { return -report::fitted_order(courants, values); };
    const Line &leapfrog = lines.at("kick-drift-kick"), &naive = lines.at("naive steps"),
               &runge = lines.at("RK4");
    const double energy_order = order(leapfrog.amplitude), shadow_order = order(leapfrog.shadow);
    run.record("kick-drift-kick", 100,
               {{"rate_energy_amplitude", energy_order}, {"rate_shadow_amplitude", shadow_order}});
    run.fill("energy-order", report::fixed(energy_order, 2));
    run.fill("shadow-order", report::fixed(shadow_order, 1));
    run.fill("shadow-ratio", report::number(leapfrog.amplitude[0] / leapfrog.shadow[0], 1));
    run.claim("energy-oscillates", [&] {
        return std::abs(energy_order - 2) < 0.02 && leapfrog.drift[0] < leapfrog.amplitude[0] / 1000;
    });
    run.claim("shadow-constant", [&] {
        return shadow_order > 3.8 && shadow_order < 4.2 && leapfrog.shadow[0] < leapfrog.amplitude[0] / 100;
    });
    run.claim("naive-drifts", [&] { return naive.drift[0] > 50 * leapfrog.drift[0]; });
    run.claim("rk4-drifts", [&] {
        bool all = true;
        for (std::size_t k = 0; k < courants.size(); ++k)
            all = all && runge.amplitude[k] < 1e-3 * leapfrog.amplitude[k] &&
                  runge.drift[k] > runge.amplitude[k];
        return all;
    });
}

/// As long as the seconds allow: a star of 400 over a hundred thousand steps.
void long_run(report::Run& run, StarScene scene) {
    scene.n = run.quick() ? 100 : 400;
    const long steps = run.quick() ? 5000 : 100000;
    const EnergyHistory longest = run_star_energy(scene, "kick-drift-kick", 0.3, 0.3, steps);
    run.record("kick-drift-kick long", scene.n,
               {{"energy_amplitude", longest.amplitude},
                {"energy_drift", longest.drift},
                {"momentum_drift", longest.momentum},
                {"steps", static_cast<double>(longest.steps)}});
    run.fill("energy-long-amplitude", report::number(longest.amplitude, 1));
    run.fill("energy-long-drift",
             std::abs(longest.drift) < 1e-10 ? "less than 10⁻¹⁰" : report::number(longest.drift, 1));
    run.claim("no-drift-for-long",
              [&] { return std::abs(longest.drift) < 1e-4 * longest.amplitude && longest.momentum < 1e-13; });
}

}  // namespace

void energy(report::Run& run) {
    plot::Figure figure{"energy", 1, 2};
    plot::Panel& left = figure.at(0, 0).titled("Δ$t$ = 0.4").labels("Ω$t$", "10^{6} Δ$E$ / $E$");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("against the time step")
                             .labels("Δ$t$ [least spacing/$c_{s}$]", "Δ$E$ / $E$");
    right.x.ticks = {0.2, 0.4, 0.8};
    StarScene scene;
    scene.n = 100;
    scene.threads = run.threads();
    const Column courants = run.quick() ? Column{0.2, 0.4} : Column{0.2, 0.4, 0.8};
    report::Table table{{"integrator", "Δt = 0.4: amplitude", "drift", "Δt = 0.2: amplitude", "drift"}};
    Lines lines;
    for (const std::string& name : star_integrators()) {
        Line& line = lines[name];
        for (const double courant : courants) {
            const auto steps = static_cast<long>((run.quick() ? 400 : 1000) / courant);
            const EnergyHistory history = run_star_energy(scene, name, 0.3, courant, steps);
            line.amplitude.push_back(history.amplitude);
            line.drift.push_back(std::max(1e-16, std::abs(history.drift)));
            line.shadow.push_back(history.shadow);
            const std::string method = name + " courant=" + report::number(courant, 2);
            run.record(method, 100,
                       {{"energy_amplitude", history.amplitude}, {"energy_drift", history.drift}});
            if (history.shadow > 0) run.record(method, 100, {{"shadow_amplitude", history.shadow}});
            if (courant == 0.4) draw_time(left, name, history);
        }
        std::vector<std::string> row{name};
        constexpr std::size_t coarse = 1, fine = 0;
        for (const std::size_t k : {coarse, fine}) {
            row.push_back(report::number(line.amplitude[k], 1));
            row.push_back(line.drift[k] < 1e-8 ? "< 10⁻⁸" : report::number(line.drift[k], 1));
        }
        table.row(row);
    }
    draw_steps(right, courants, lines);
    right.legend.outside = true;
    left.legend.shown = false;
    run.save(figure);
    run.fill("energy", table.markdown());
    claims(run, courants, lines);
    long_run(run, scene);
}

}  // namespace sph::euler
