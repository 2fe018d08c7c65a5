#include <algorithm>

#include "chapters/08_landau_model/scenes/grid.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/race.hpp"

/// What accuracy costs in the two blasts.
namespace sph::landau {
namespace {

TubeScene sized(int which, std::size_t n) {
    TubeScene scene = problem(which);
    scene.n = n;
    return scene;
}

report::Lap lap(const TubeRun& tube, const TubeScene& scene) {
    return {tube.l1_rho,
            tube.seconds,
            0,
            {{"l1_v", tube.l1_v},
             {"shock_error", shock_of(tube, scene).value_or(nowhere).error},
             {"steps", static_cast<double>(tube.counters.steps)}}};
}

/// Both dissipations, and the grid with twice as many cells.
std::vector<report::Contestant> contestants(int which, const std::vector<std::size_t>& sizes) {
    std::vector<report::Contestant> all;
    for (const TubeMethod& method : relativistic_methods().named({"chow-monaghan", "reconstructed"}))
        all.push_back({method.name, method.label, method.styled(),
                       [which, method](std::size_t n) {
                           const TubeScene scene = sized(which, n);
                           return lap(run_relativistic_tube(scene, method), scene);
                       },
                       sizes});
    std::vector<std::size_t> twice;
    for (const std::size_t n : sizes) twice.push_back(2 * n);
    all.push_back({"grid", "grid", plot::competitor("grid"),
                   [which](std::size_t n) {
                       const TubeScene scene = sized(which, n);
                       return lap(run_grid_relativistic_tube(scene), scene);
                   },
                   twice});
    return all;
}

const report::Track& track_named(const std::vector<report::Track>& tracks, const std::string& name) {
    return *std::find_if(tracks.begin(), tracks.end(), [&](const auto& one) { return one.who.name == name; });
}
/// How many times faster the grid is at the particles' last error.
double lead_of_grid(const std::vector<report::Track>& tracks) {
    const auto& best = track_named(tracks, "reconstructed");
    const double error = best.error.back();
    return best.seconds.back() / track_named(tracks, "grid").seconds_at_error(error).value;
}

}  // namespace

void tube_cost(report::Run& run) {
    plot::Figure figure{"tube-cost", 1, 2};
    using namespace report;
    Comparison table{{"problem", "method", "N"},
                     {{"ρ %", "l1_rho", in_percent()},
                      {"v %", "l1_v", in_percent()},
                      {"shock %", "shock_error", in_percent()},
                      {"steps", "steps", whole()},
                      {"CPU ms", "cpu_seconds", time_in(1e-3)}}};
    plot::Values leads;
    bool late = false;
    for (int which = 1; which <= 2; ++which) {
        plot::Panel& axes = figure.at(0, which - 1)
                                .log_log()
                                .titled(which == 1 ? "first blast" : "second blast")
                                .labels("CPU time [s]", which == 1 ? "relative $L$_{1} error of ρ" : "");
        axes.legend.shown = which == 1;
        const auto sizes = which == 1 ? run.sizes({50, 100}, {50, 100, 200, 400, 800})
                                      : run.sizes({40, 80}, {40, 80, 120, 160, 240});
        const report::RaceCourse course{
            .name = "problem " + std::to_string(which), .quantity = "l1_rho", .repeats = 1};
        const auto tracks = report::race(run, course, contestants(which, sizes));
        leads.push_back(lead_of_grid(tracks));
        for (const report::Track& track : tracks) {
            for (std::size_t k = 0; k < track.n.size(); ++k) {
                if (which == 2 && !(report::value_of(track.lap(k), "shock_error") < 1)) late = true;
            }
        }
        report::draw_error_against_seconds(axes, tracks);
        for (const report::Track& track : tracks) {
            // The thin shell of problem 2: the classical dissipation leaves noise that amplifies rounding.
            const bool noisy = which == 2 && track.who.name == "chow-monaghan";
            for (std::size_t k = 0; k < track.n.size(); ++k)
                table.show({std::to_string(which), track.who.label, std::to_string(track.n[k])}, track.lap(k),
                           noisy ? Digits::noisy : Digits::stable);
        }
    }
    run.save(figure);
    run.fill("tube-cost", table.markdown());
    run.claim("tube-grid", [&] { return leads[0] > 50 && leads[1] > 50; });
    run.claim("tube-late", [&] { return late; });
}

}  // namespace sph::landau
