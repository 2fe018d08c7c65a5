#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/one_at_a_time.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"
#include "common/report/race.hpp"

#include <algorithm>

namespace sph::shocks {
namespace {

/// Methods, and the grid, which does not say what energy it loses.
std::vector<report::Contestant> contestants(const report::Run& run) {
    std::vector<report::Contestant> all;
    for (const Method<1>& method : tube_methods().named(
             {"alpha-beta", "bulk", "signal", "beta-alone", "thermokinetic", "morris-monaghan", "none",
              "narrow", "none-narrow", "reconstructed-cubic", "reconstructed"})) {
        all.push_back(
            {method.name, method.label, method.styled(), [method, threads = run.threads()](std::size_t n) {
                 const StandingWaveRun wave = run_standing_wave({.n = n, .threads = threads}, method);
                 return report::Lap{wave.error, 0, 0, {{"energy_lost", 1 - wave.energy_left}}};
             }});
    }
    all.push_back({"grid", "grid, Eulerian", plot::competitor("grid"),
                   [](std::size_t n) { return report::Lap{grid_standing_wave(n).error}; }});
    return all;
}

const std::vector<std::string>& spoken_of() {
    static const std::vector<std::string> names{"alpha-beta", "none", "none-narrow", "reconstructed", "grid"};
    return names;
}
bool shown(const std::string& name) {
    return std::find(spoken_of().begin(), spoken_of().end(), name) != spoken_of().end();
}
const report::Track& track_of(const std::vector<report::Track>& tracks, const std::string& name) {
    return *std::find_if(tracks.begin(), tracks.end(),
                         [&](const report::Track& track) { return track.who.name == name; });
}
double error_at_64(const std::vector<report::Track>& tracks, const std::string& name) {
    return track_of(tracks, name).error[2];
}

/// One thing changes from row to row: the viscosity, or the kernel. `signal_narrow`: the error of the signal
/// velocity on the narrow kernel, with the K of the wide one.
std::string story_table(const std::vector<report::Track>& tracks, double signal_narrow) {
    report::Table table{{"viscosity", "kernel, h/dx", "error of v %, N = 64"}};
    const std::string wide = "cubic, 1.2", narrow = "quadratic, 1";
    const auto at = [&](const char* name) { return error_at_64(tracks, name); };
    for (const auto& [error, viscosity, kernel] : {std::tuple{at("alpha-beta"), "α = 1, β = 2", wide},
                                                   {at("signal"), "signal, K = 0.5", wide},
                                                   {signal_narrow, "signal, K = 0.5", narrow},
                                                   {at("morris-monaghan"), "Morris–Monaghan", wide},
                                                   {at("none"), "none", wide},
                                                   {at("none-narrow"), "none", narrow},
                                                   {at("reconstructed-cubic"), "reconstructed", wide},
                                                   {at("reconstructed"), "reconstructed", narrow}})
        table.row({viscosity, kernel, report::percent(error)});
    return table.markdown();
}

}  // namespace

void wave(report::Run& run) {
    plot::Figure figure{"wave", 1, 2};
    plot::Panel& error_panel =
        figure.at(0, 1).log_log().labels("particles $N$", "relative $L$_{1} error of $v$");
    plot::Panel& energy_panel =
        figure.at(0, 0).log_log().labels("particles $N$", "energy of the wave lost in a period");
    const auto tracks =
        report::race(run, {.sizes = run.sizes({16, 32, 64}, {16, 32, 64, 128, 256}), .quantity = "l1_v"},
                     contestants(run));
    report::draw_error_against_size(error_panel, tracks, spoken_of());
    report::Table table{{"method", "N = 16", "N = 32", "N = 64", "order", "α = 1 over it, N = 64"}};
    const double of_alpha = tracks.front().error[2];
    const auto at_64 = [&](const std::string& name) { return error_at_64(tracks, name); };
    for (const report::Track& track : tracks) {
        const plot::Values n = track.sizes(), &error = track.error;
        const double order = report::observed_order(n[0], error[0], n.back(), error.back());
        const std::string gain = report::number(of_alpha / error[2], 2);
        table.row({track.who.label, report::number(error[0], 2), report::number(error[1], 2),
                   report::number(error[2], 2), report::fixed(order, 1), gain});
        if (track.who.name == "grid") continue;
        run.record(track.who.name, track.n.back(), {{"rate_l1_v", order}});
        plot::Values lost;
        for (const report::Quantities& more : track.more) lost.push_back(more[0].value);
        if (shown(track.who.name) && !track.who.name.starts_with("none"))
            energy_panel.curve(n, lost, track.who.look);
    }
    const double viscosity = at_64("alpha-beta") / at_64("none"),
                 kernel = at_64("none") / at_64("none-narrow");
    run.fill("wave-gain", report::number(of_alpha / at_64("reconstructed"), 2));
    run.fill("wave-gain-viscosity", report::number(viscosity, 2));
    run.fill("wave-gain-kernel", report::number(kernel, 2));
    const StandingWave at_size{.n = static_cast<std::size_t>(tracks.front().n[2]), .threads = run.threads()};
    const double signal_narrow = run_standing_wave(at_size, combination({}).line).error;
    run.fill("wave-story", story_table(tracks, signal_narrow));
    // Each of both alone leaves the other's error.
    run.claim(
        "wave-both",
        [&] {
            return at_64("morris-monaghan") < 1.1 * at_64("reconstructed-cubic") &&
                   at_64("reconstructed-cubic") > 0.8 * at_64("none") &&
                   signal_narrow > 10 * at_64("none-narrow") && signal_narrow > 0.9 * at_64("signal") &&
                   at_64("reconstructed") < 1.5 * at_64("none-narrow");
        },
        report::Needs::any_run);
    run.claim(
        "wave-grid", [&] { return at_64("grid") < at_64("reconstructed") / 3; }, report::Needs::any_run);
    energy_panel.legend.shown = false;
    error_panel.legend.outside = true;
    run.save(figure);
    run.fill("wave", table.markdown());
}

}  // namespace sph::shocks
