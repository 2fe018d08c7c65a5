#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"
#include "common/report/race.hpp"

namespace sph::shocks {
namespace {

/// Methods, and the grid, which does not say what energy it loses.
std::vector<report::Contestant> contestants(const report::Run& run) {
    std::vector<report::Contestant> all;
    for (const Method<1>& method : tube_methods().named(
             {"alpha-beta", "bulk", "signal", "thermokinetic", "morris-monaghan", "none", "reconstructed"})) {
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
    report::draw_error_against_size(error_panel, tracks);
    report::Table table{{"method", "N = 16", "N = 32", "N = 64", "order", "α = 1 over it, N = 64"}};
    const double of_alpha = tracks.front().error[2];
    for (const report::Track& track : tracks) {
        const plot::Values n = track.sizes(), &error = track.error;
        const double order = report::observed_order(n[0], error[0], n.back(), error.back());
        const std::string gain = report::number(of_alpha / error[2], 2);
        table.row({track.who.label, report::number(error[0], 2), report::number(error[1], 2),
                   report::number(error[2], 2), report::fixed(order, 1), gain});
        if (track.who.name == "reconstructed") run.fill("wave-gain", gain);
        if (track.who.name == "grid") continue;
        run.record(track.who.name, track.n.back(), {{"rate_l1_v", order}});
        plot::Values lost;
        for (const report::Quantities& more : track.more) lost.push_back(more[0].value);
        if (track.who.name != "none") energy_panel.curve(n, lost, track.who.look);
    }
    energy_panel.legend.shown = false;
    error_panel.legend.outside = true;
    run.save(figure);
    run.fill("wave", table.markdown());
}

}  // namespace sph::shocks
