#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/05_tensile_instability/scenes/elastic_grid.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/race.hpp"

namespace sph::tensile {
namespace {

const std::vector<std::string> racing{"jaumann", "corrected-rate", "total-lagrangian"};

/// The laws of solids, and a grid, which is given larger sizes too: up to about their time.
std::vector<report::Track> race_waves(report::Run& run, plot::Panel& panel, Polarisation polarisation) {
    const auto sized = [polarisation](std::size_t n) {
        return ElasticWaveScene{.polarisation = polarisation, .n = n};
    };
    std::vector<report::Contestant> all;
    for (const SolidMethod& method : solid_methods().named(racing)) {
        all.push_back({method.name, method.label, plot::look_of(method.name, method.label),
                       [sized, method](std::size_t n) {
                           const ElasticWaveRun wave = run_elastic_wave(sized(n), method);
                           return report::Lap{wave.error, wave.seconds};
                       }});
    }
    all.push_back({"grid", "grid", plot::look_of("grid", "grid"),
                   [sized](std::size_t n) { return run_grid_elastic_wave(sized(n)); },
                   run.sizes({16, 32}, {16, 24, 32, 48, 64, 96, 128, 192, 256, 384})});
    auto tracks = report::race(run,
                               {.name = std::string{name_of(polarisation)},
                                .sizes = run.sizes({16, 32}, {16, 24, 32, 48, 64, 96, 128}),
                                .quantity = "l1_v",
                                .repeat_below = 0.02},
                               all);
    report::draw_error_against_seconds(panel, tracks);
    return tracks;
}

/// The seconds from which on the error stays below the bound, between two laps on a logarithmic scale. Where
/// errors of two signs cancel, an error is small by chance and rises again: that is no answer. Infinite where
/// the last lap is above the bound; those of the first lap where all are below.
double seconds_to_stay_below(const report::Track& track, double bound) {
    std::size_t k = track.error.size();
    while (k > 0 && track.error[k - 1] <= bound) --k;
    if (k == track.error.size()) return std::numeric_limits<double>::infinity();
    if (k == 0) return track.seconds[0];
    const double way = std::log(track.error[k - 1] / bound) / std::log(track.error[k - 1] / track.error[k]);
    return track.seconds[k - 1] * std::pow(track.seconds[k] / track.seconds[k - 1], way);
}
std::string text_of(double seconds) {
    return std::isfinite(seconds) ? report::timing(1e3 * seconds) : report::never_reached;
}

}  // namespace

/// What accuracy costs in a solid: P and S waves by particles and by a grid.
void solid_cost(report::Run& run) {
    plot::Figure figure{"solid-cost", 1, 2};
    figure.share_y = true;
    constexpr double bound = 0.02, closer = 0.005;
    std::vector<std::vector<report::Track>> waves;
    for (const Polarisation wave : {Polarisation::longitudinal, Polarisation::transverse}) {
        const bool first = wave == Polarisation::longitudinal;
        plot::Panel& panel = figure.at(0, first ? 0 : 1)
                                 .log_log()
                                 .titled(first ? "P wave" : "S wave")
                                 .labels("CPU time [s]", "relative $L$_{1} error of $v$");
        panel.legend.shown = first;
        waves.push_back(race_waves(run, panel, wave));
    }
    run.save(figure);
    report::Table table{{"form", "P: ms to 2 %", "to 0.5 %", "S: ms to 2 %", "to 0.5 %"}};
    for (std::size_t k = 0; k < waves[0].size(); ++k) {
        std::vector<std::string> row{waves[0][k].who.label};
        for (const auto& tracks : waves)
            for (const double to : {bound, closer})
                row.push_back(text_of(seconds_to_stay_below(tracks[k], to)));
        table.row(row);
    }
    run.fill("solid-cost", table.markdown());
    // The least of both waves.
    const auto ratio = [&](std::size_t slower, std::size_t faster, double to) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& tracks : waves)
            least = std::min(
                least, seconds_to_stay_below(tracks[slower], to) / seconds_to_stay_below(tracks[faster], to));
        return least;
    };
    enum : std::size_t { printed, corrected, lagrangian, grid };
    run.fill("grid-faster", report::timing(ratio(lagrangian, grid, closer), 1));
    run.fill("lagrangian-faster", report::timing(ratio(corrected, lagrangian, bound), 1));
    run.claim("cost-grid-wins", [&] { return run.checking() || ratio(lagrangian, grid, closer) > 30; });
    run.claim("cost-lagrangian-first",
              [&] { return run.checking() || ratio(corrected, lagrangian, bound) > 2; });
    run.claim("cost-floor", [&] {
        return std::all_of(waves.begin(), waves.end(), [&](const auto& tracks) {
            const auto &of_printed = tracks[printed].error, &of_corrected = tracks[corrected].error;
            const double share = of_corrected.back() / of_printed.back();
            const auto least = std::min_element(of_corrected.begin(), of_corrected.end());
            return of_printed.back() > bound && share > 0.35 && share < 0.65 && *least < closer &&
                   of_corrected.back() > closer;
        });
    });
}

}  // namespace sph::tensile
