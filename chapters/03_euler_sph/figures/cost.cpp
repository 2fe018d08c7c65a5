#include <algorithm>
#include <limits>

#include "chapters/03_euler_sph/scenes/grid.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"
#include "common/plot/looks.hpp"
#include "common/report/race.hpp"

/// What accuracy costs. Whole runs without their set-up: CPU seconds of one thread, the best of three.
namespace sph::euler {
namespace {

/// How many times as long as the competitor, the last of the tracks, others need.
struct Lead {
    double first = 0, last = 0;  ///< the one before it, for the first and the last bound
    double least = std::numeric_limits<double>::infinity();  ///< any, for any bound that it reaches
};

/// The first size at which each contestant reaches the bounds.
Lead at_bounds(report::Run& run, const std::vector<report::Track>& tracks, const std::vector<double>& bounds,
               const std::string& text) {
    std::vector<std::string> header{"task"};
    for (const double bound : bounds) header.push_back("error ≤ " + report::number(bound, 1));
    report::Table table{header};
    const auto seconds = [](const report::Track& track, double bound) {
        const std::size_t k = track.first_below(bound);
        return k < track.n.size() ? track.seconds[k] : 0;
    };
    for (const report::Track& track : tracks) {
        std::vector<std::string> row{track.who.label};
        for (const double bound : bounds) {
            const std::size_t k = track.first_below(bound);
            row.push_back(k == track.n.size() ? report::never_reached
                                              : "N = " + std::to_string(track.n[k]) + ", " +
                                                    report::timing(1e3 * track.seconds[k]) + " ms");
        }
        table.row(row);
    }
    run.fill(text, table.markdown());
    Lead lead;
    const auto times = [&](const report::Track& track, double bound) {
        return seconds(track, bound) / seconds(tracks.back(), bound);
    };
    const report::Track& best = tracks[tracks.size() - 2];
    lead.first = times(best, bounds.front());
    lead.last = times(best, bounds.back());
    for (std::size_t k = 0; k + 1 < tracks.size(); ++k) {
        for (const double bound : bounds) {
            if (seconds(tracks[k], bound) > 0) lead.least = std::min(lead.least, times(tracks[k], bound));
        }
    }
    return lead;
}

/// The methods that converge, and a Lagrangian grid, which is given larger sizes too.
std::vector<report::Contestant> contestants(
    const std::vector<GasMethod>& methods, std::vector<std::size_t> sizes, bool quick,
    const std::function<report::Lap(std::size_t, const GasMethod&)>& particles,
    const std::function<report::Lap(std::size_t)>& grid) {
    std::vector<report::Contestant> all;
    for (const GasMethod& method : methods)
        all.push_back({method.name, method.label, method.look,
                       [particles, method](std::size_t n) { return particles(n, method); }});
    if (!quick) sizes.insert(sizes.end(), {192, 288, 384});
    all.push_back({"grid", "Lagrangian grid", plot::competitor("Lagrangian grid"), grid, sizes});
    return all;
}

Lead wave_race(report::Run& run, plot::Panel& panel) {
    const std::vector<std::size_t> sizes = run.quick()
                                               ? std::vector<std::size_t>{16, 32}
                                               : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128};
    const auto particles = [](std::size_t n, const GasMethod& method) {
        WaveScene scene;
        scene.n = n;
        const WaveRun wave = run_wave(scene, method);
        return report::Lap{wave.error, wave.seconds};
    };
    const auto tracks =
        report::race(run, {.name = "wave", .sizes = sizes},
                     contestants(compared_methods(), sizes, run.quick(), particles, run_grid_wave));
    report::draw_error_against_seconds(panel, tracks);
    return at_bounds(run, tracks, {0.05, 0.01, 1e-3, 1e-4}, "cost-wave");
}

Lead star_race(report::Run& run, plot::Panel& panel) {
    const std::vector<std::size_t> sizes =
        run.quick() ? std::vector<std::size_t>{25, 50} : std::vector<std::size_t>{25, 35, 50, 75, 100};
    constexpr double A_0 = 1;
    const auto particles = [](std::size_t n, const GasMethod& method) {
        StarScene scene;
        scene.n = n;
        const NonlinearRun swing = run_nonlinear(scene, method, A_0, scene.exact(A_0).period());
        return report::Lap{swing.radius_error, swing.seconds};
    };
    // One h does not converge, and with mean h there is no star at rest to begin with.
    std::vector<GasMethod> methods;
    for (const GasMethod& method : compared_methods(1.2)) {
        if (method.name != "fixed-h" && method.name != "averaged-h") methods.push_back(method);
    }
    const auto tracks = report::race(run, {.name = "star", .sizes = sizes},
                                     contestants(methods, sizes, run.quick(), particles,
                                                 [](std::size_t n) { return run_grid_star(n, A_0); }));
    report::draw_error_against_seconds(panel, tracks);
    run.claim("floors", [&] {
        const auto& cubic = std::find_if(tracks.begin(), tracks.end(), [](const report::Track& track) {
                                return track.who.name == "consistent-h";
                            })->error;  // N = 25, 35, 50, 75, 100
        return cubic[2] < cubic[1] && cubic[3] > 1.5 * cubic[2] && cubic[4] > cubic[3];
    });
    return at_bounds(run, tracks, {0.01, 1e-3, 1e-4}, "cost-star");
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 1, 2};
    plot::Panel& waves = figure.at(0, 0)
                             .log_log()
                             .titled("standing wave, one period")
                             .labels("CPU time [s]", "relative $L$_{1} error of $v$");
    plot::Panel& stars = figure.at(0, 1)
                             .log_log()
                             .titled("nonlinear star, one period")
                             .labels("CPU time [s]", "relative error of the radius");
    const Lead wave = wave_race(run, waves), star = star_race(run, stars);
    run.fill("cost-wave-ratio", report::timing(wave.last, 1));
    run.fill("cost-star-ratio", report::timing(star.last, 1));
    // Times of one machine; the leads at the bounds are 4 and 5, and 80 and 60 at the first.
    run.claim("grid-ahead", [&] { return wave.least > 1 && star.least > 1; });
    run.claim("lead-shrinks", [&] { return wave.last < wave.first / 3 && star.last < star.first / 3; });
    stars.legend.shown = false;
    waves.legend.outside = true;
    run.save(figure);
}

}  // namespace sph::euler
