#include <algorithm>

#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "chapters/07_godunov_sph/figures/line.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::godunov {
namespace {

report::Contestant contestant(const report::Run& run, const Method<1>& method) {
    return {method.name, method.label, method.styled(), [method, threads = run.threads()](std::size_t n) {
                return report::Lap{run_standing_wave({.n = n, .threads = threads}, method).error};
            }};
}
const report::Track& track_of(const std::vector<report::Track>& tracks, const std::string& name) {
    return *std::find_if(tracks.begin(), tracks.end(),
                         [&](const report::Track& track) { return track.who.name == name; });
}

}  // namespace

void wave(report::Run& run) {
    std::vector<report::Contestant> contestants;
    for (const Method<1>& method : one_at_a_time()) contestants.push_back(contestant(run, method));
    for (const char* name : {"alpha-beta", "reconstructed"})
        contestants.push_back(contestant(run, of_chapter_4(name)));
    contestants.push_back({"grid", "grid, Eulerian", plot::competitor("grid"),
                           [](std::size_t n) { return report::Lap{shocks::grid_standing_wave(n).error}; }});
    const auto tracks = report::race(
        run, {.sizes = run.sizes({16, 32, 64}, {16, 32, 64, 128}), .quantity = "l1_v"}, contestants);
    plot::Figure figure{"wave", 1, 1};
    figure.panel_width = 520;
    plot::Panel& panel = figure.at(0, 0).log_log().labels("particles $N$", "relative $L$_{1} error of $v$");
    report::draw_error_against_size(panel, tracks,
                                    {"inutsuka", "godunov", "alpha-beta", "reconstructed", "grid"});
    panel.slope(-2, 40, 120, 3e-2, "order 2");
    panel.slope(-3, 40, 120, 1.2e-4, "order 3");
    panel.legend.outside = true;
    run.save(figure);
    report::Table table{{"method", "N = 16", "N = 64", "order"}};
    for (const report::Track& track : tracks) {
        const double order = report::observed_order(track.sizes()[0], track.error[0], track.sizes().back(),
                                                    track.error.back());
        run.record(track.who.name, track.n.back(), {{"rate_l1_v", order}});
        table.row({track.who.label, report::number(track.error[0], 2), report::number(track.error[2], 2),
                   report::fixed(order, 1)});
    }
    run.fill("wave", table.markdown());
    const auto at_64 = [&](const char* name) { return track_of(tracks, name).error[2]; };
    run.fill("wave-64", report::number(at_64("godunov"), 2));
    run.claim(
        "wave-gate",
        [&] {
            return at_64("godunov") < 1e-4 && track_of(tracks, "godunov").error[1] > 7 * at_64("godunov");
        },
        report::Needs::any_run);
    run.claim(
        "wave-orders",
        [&] {
            const plot::Values& error = track_of(tracks, "varying-h").error;
            return error[1] / error[2] > 3.5 && error[1] / error[2] < 5;
        },
        report::Needs::any_run);
    run.claim(
        "wave-second-order",
        [&] { return at_64("varying-h") > 20 * at_64("godunov") && at_64("inutsuka") > at_64("varying-h"); },
        report::Needs::any_run);
    run.claim(
        "wave-beside",
        [&] {
            return at_64("reconstructed") > 10 * at_64("godunov") && at_64("grid") > 2 * at_64("godunov");
        },
        report::Needs::any_run);
}

}  // namespace sph::godunov
