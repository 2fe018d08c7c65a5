#include <algorithm>
#include <limits>
#include <map>

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
    std::vector<std::size_t> sizes, grid_sizes;  ///< grids: up to about the time that the methods take
    double error, seconds;                       ///< of the tables "at equal error" and "at equal time"
    OfMethod method{};
    OfGrid grid{};
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
    const Problem sod{.name = "sod",
                      .title = "Sod",
                      .error_of = "ρ",
                      .sizes = {45, 90, 180, 360, 540},
                      .grid_sizes = {45, 90, 180, 360, 720, 1440, 2880, 5760},
                      .error = 0.01,
                      .seconds = 0.01};
    const Problem blast{.name = "blast",
                        .title = "blast",
                        .error_of = "ρ",
                        .sizes = {50, 75, 100, 150, 200},
                        .grid_sizes = {25, 50, 100, 200, 400, 800, 1600, 3200},
                        .error = 0.04,
                        .seconds = 0.02};
    return {tube(sod, {}),
            tube(blast, {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006}),
            // Multiples of 10: the jumps of the start, at 0.1 and 0.9, fall between two cells.
            {.name = "woodward-colella",
             .title = "Woodward–Colella",
             .error_of = "ρ",
             .sizes = {50, 80, 100, 150, 200},
             .grid_sizes = {20, 50, 100, 200, 400, 800, 1600, 3200},
             .error = 0.15,
             .seconds = 0.05,
             .method = blast_waves,
             .grid = grid_blast_waves},
            {.name = "wave",
             .title = "standing wave",
             .error_of = "$v$",
             .sizes = {16, 32, 64, 96, 128},
             .grid_sizes = {16, 32, 64, 128, 256, 512},
             .error = 0.01,
             .seconds = 0.001,
             .method = wave,
             .grid = grid_wave}};
}

/// All methods that dissipate, and both grids.
std::vector<report::Contestant> contestants(const Problem& problem) {
    std::vector<report::Contestant> all;
    for (const Method<1>& method : tube_contestants())
        all.push_back({method.name, method.label, method.styled(),
                       [run = problem.method, method](std::size_t n) { return run(method, n); }});
    for (const Grid& grid : grids())
        all.push_back({grid.name, grid.label, grid.look,
                       [run = problem.grid, frame = grid.frame](std::size_t n) { return run(frame, n); },
                       problem.grid_sizes});
    return all;
}

/// What the table says of a problem, in numbers.
struct Costs {
    std::map<std::string, double> seconds, error;  ///< infinite where there is no reading
};
Costs costs(const Problem& problem, const std::vector<report::Track>& tracks) {
    using Kind = report::Reading::Kind;
    Costs told;
    for (const report::Track& track : tracks) {
        const auto number = [](const report::Reading& reading) {
            const bool read = reading.kind == Kind::value || reading.kind == Kind::at_most;
            return read ? reading.value : std::numeric_limits<double>::infinity();
        };
        told.seconds[track.who.name] = number(track.seconds_at_error(problem.error));
        told.error[track.who.name] = number(track.error_in_seconds(problem.seconds));
    }
    return told;
}
/// The least of all particles' methods but one.
double best(const std::map<std::string, double>& told, const std::string& but = "") {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [name, value] : told) {
        if (!name.starts_with("grid") && name != but) least = std::min(least, value);
    }
    return least;
}

/// What the text says of the table. Nothing is asserted where only the text is compared: then each time is
/// measured once, beside whatever runs.
void assert_text(report::Run& run, const std::vector<Costs>& told) {
    const Costs &sod = told[0], &blast = told[1], &colliding = told[2], &wave = told[3];
    const auto faster = [](const Costs& of, const char* grid) {
        return best(of.seconds) / of.seconds.at(grid);
    };
    const auto closer = [](const Costs& of, const char* grid) { return best(of.error) / of.error.at(grid); };
    const char *fixed = "grid", *moving = "grid-lagrangian";
    run.claim("cost-at-equal-error", [&] {
        return run.checking() ||
               (faster(sod, fixed) > 100 && faster(sod, moving) > 100 && faster(blast, moving) > 100 &&
                faster(colliding, moving) > 100 && faster(blast, fixed) > 10 &&
                faster(colliding, fixed) > 10 && faster(wave, fixed) > 10 && faster(wave, moving) > 10);
    });
    run.claim("cost-at-equal-time", [&] {
        return run.checking() ||
               (closer(sod, moving) > 10 && closer(blast, moving) > 10 && closer(colliding, moving) > 10 &&
                closer(sod, fixed) > 10 && closer(blast, fixed) > 3 && closer(colliding, fixed) > 2 &&
                closer(wave, fixed) > 100 && closer(wave, moving) > 100);
    });
    run.claim("cost-of-particles", [&] {
        const auto lead = [](const Costs& of, const char* name) {
            return best(of.seconds, name) / of.seconds.at(name);
        };
        constexpr double noise = 1.1;  // of times that are equal
        const double of_1983 = sod.seconds.at("monaghan-gingold") / sod.seconds.at("reconstructed");
        return run.checking() ||
               (lead(wave, "reconstructed") > 3 && lead(sod, "monaghan-gingold") > 1 / noise &&
                of_1983 > 1 / 1.5 && lead(colliding, "narrow") > 1.3 && lead(blast, "narrow") > 1 / noise);
    });
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 2, 2};
    std::vector<std::vector<std::string>> rows;
    for (const report::Contestant& who : contestants(problems()[0])) rows.push_back({who.label});
    std::vector<Costs> told;
    int k = 0;
    for (Problem& problem : problems()) {
        plot::Panel& axes = figure.at(k / 2, k % 2)
                                .log_log()
                                .titled(problem.title)
                                .labels("CPU time [s]", "relative $L$_{1} error of " + problem.error_of);
        axes.legend.shown = k++ == 1;
        axes.legend.outside = true;
        if (run.quick()) problem.sizes.resize(2), problem.grid_sizes.resize(2);
        const auto tracks = report::race(
            run, {.name = problem.name, .sizes = problem.sizes, .repeat_below = 0.02}, contestants(problem));
        report::draw_error_against_seconds(
            axes, tracks, {"reconstructed", "alpha-beta", "narrow", "morris-monaghan", "grid"});
        told.push_back(costs(problem, tracks));
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
    assert_text(run, told);
}

}  // namespace sph::shocks
