#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "common/report/race.hpp"

/// What accuracy costs: the steps of whole runs, without set-up, in CPU seconds of one thread.
namespace sph::shocks {
namespace {

using OfMethod = std::function<report::Lap(const Method<1>&, std::size_t)>;
using OfGrid = std::function<report::Lap(exact::Frame, std::size_t)>;

struct Problem {
    std::string name, title, error_of;
    std::vector<std::size_t> sizes;
    double error, seconds;  ///< of the tables "at equal error" and "at equal time"
    OfMethod method;
    OfGrid grid;
};

report::Lap lap(const TubeRun& tube) {
    return {tube.l1_rho, tube.seconds};
}

Problem tube(Problem described, const TubeScene& scene) {
    const auto sized = [scene](std::size_t n) {
        TubeScene one = scene;
        one.n = n;
        return one;
    };
    described.method = [sized](const Method<1>& method, std::size_t n) {
        return lap(run_tube(sized(n), method));
    };
    described.grid = [sized](exact::Frame frame, std::size_t n) {
        return lap(run_grid_tube(sized(n), frame));
    };
    return described;
}

std::vector<Problem> problems() {
    const auto blast_waves = [](const Method<1>& method, std::size_t n) {
        return lap(run_blast_waves({.n = n}, method));
    };
    const auto grid_blast_waves = [](exact::Frame frame, std::size_t n) {
        return lap(run_grid_blast_waves({.n = n}, frame));
    };
    const auto wave = [](const Method<1>& method, std::size_t n) {
        const StandingWaveRun run = run_standing_wave({.n = n}, method);
        return report::Lap{run.error, run.seconds};
    };
    const auto grid_wave = [](exact::Frame frame, std::size_t n) {
        const GridWave run = grid_standing_wave(n, frame);
        return report::Lap{run.error, run.seconds};
    };
    return {tube({"sod", "Sod", "ρ", {45, 90, 180, 360, 540}, 0.01, 0.01, {}, {}}, {}),
            tube({"blast", "blast", "ρ", {50, 75, 100, 150, 200}, 0.04, 0.02, {}, {}},
                 {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006}),
            {"woodward-colella",
             "Woodward–Colella",
             "ρ",
             {50, 75, 100, 150, 200},
             0.15,
             0.05,
             blast_waves,
             grid_blast_waves},
            {"wave", "standing wave", "$v$", {16, 32, 64, 96, 128}, 0.01, 0.001, wave, grid_wave}};
}

/// All methods that dissipate, and both grids.
std::vector<report::Contestant> contestants(const Problem& problem) {
    std::vector<report::Contestant> all;
    for (const Method<1>& method : tube_contestants())
        all.push_back({method.name, method.label, method.styled(),
                       [run = problem.method, method](std::size_t n) { return run(method, n); }});
    for (const Grid& grid : grids())
        all.push_back({grid.name, grid.label, grid.look,
                       [run = problem.grid, frame = grid.frame](std::size_t n) { return run(frame, n); }});
    return all;
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 2, 2};
    std::vector<std::vector<std::string>> rows;
    for (const report::Contestant& who : contestants(problems()[0])) rows.push_back({who.label});
    int k = 0;
    for (Problem& problem : problems()) {
        plot::Panel& axes = figure.at(k / 2, k % 2)
                                .log_log()
                                .titled(problem.title)
                                .labels("CPU time [s]", "relative $L$_{1} error of " + problem.error_of);
        axes.legend.shown = k++ == 1;
        axes.legend.outside = true;
        if (run.quick()) problem.sizes.resize(2);
        const auto tracks = report::race(
            run, {.name = problem.name, .sizes = problem.sizes, .repeat_below = 0.02}, contestants(problem));
        report::draw_error_against_seconds(axes, tracks);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            rows[row].push_back(tracks[row].seconds_at_error(problem.error).text(1e3));
            rows[row].push_back(tracks[row].error_in_seconds(problem.seconds).text(100));
        }
    }
    run.save(figure);
    report::Table table{{"method", "Sod: ms to ρ 1 %", "ρ % in 10 ms", "blast: ms to ρ 4 %", "ρ % in 20 ms",
                         "W–C: ms to ρ 15 %", "ρ % in 50 ms", "wave: ms to v 1 %", "v % in 1 ms"}};
    for (const auto& row : rows) table.row(row);
    run.fill("cost", table.markdown());
}

}  // namespace sph::shocks
