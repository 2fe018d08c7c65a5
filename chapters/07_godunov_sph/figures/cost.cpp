#include <algorithm>
#include <limits>
#include <map>

#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "chapters/07_godunov_sph/figures/line.hpp"

/// What accuracy costs: the steps of whole runs, without set-up, in CPU seconds of one thread.
namespace sph::godunov {
namespace {

using OfMethod = std::function<report::Lap(const Method<1>&, std::size_t)>;
using OfGrid = std::function<report::Lap(exact::Frame, std::size_t)>;

struct Problem {
    std::string name, title, error_of;
    std::vector<std::size_t> sizes, grid_sizes;
    double error;  ///< of the table "at equal error"
    OfMethod method;
    OfGrid grid;
};

template <class Tube>
report::Lap lap(const Tube& tube) {
    return {tube.l1_rho, tube.seconds, 0, {{"steps", static_cast<double>(tube.counters.steps)}}};
}
Problem tube(const std::string& name, const std::string& title, const shocks::TubeScene& scene, double error,
             const std::vector<std::size_t>& sizes) {
    const auto sized = [scene](std::size_t n) {
        shocks::TubeScene one = scene;
        one.n = n;
        return one;
    };
    return {name,
            title,
            "ρ",
            sizes,
            {50, 100, 200, 400, 800, 1600},
            error,
            [sized](const Method<1>& method, std::size_t n) { return lap(run_tube(sized(n), method)); },
            [sized](exact::Frame frame, std::size_t n) { return lap(run_grid_tube(sized(n), frame)); }};
}
std::vector<Problem> problems() {
    const auto wave = [](const Method<1>& method, std::size_t n) {
        const shocks::StandingWaveRun run = run_standing_wave({.n = n}, method);
        return report::Lap{run.error, run.seconds, 0, {{"steps", static_cast<double>(run.counters.steps)}}};
    };
    const auto grid_wave = [](exact::Frame frame, std::size_t n) {
        const shocks::GridWave run = shocks::grid_standing_wave(n, frame);
        return report::Lap{run.error, run.seconds};
    };
    return {
        tube("sod", "Sod", {}, 0.01, {45, 90, 180, 360, 540}),
        tube("blast", "blast", {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006}, 0.03, {50, 75, 100, 150, 200}),
        {"wave",
         "standing wave",
         "$v$",
         {12, 16, 32, 64, 128},
         {12, 16, 32, 64, 128, 256},
         0.01,
         wave,
         grid_wave}};
}
/// alpha = 1 reaches 1 % of the wave with far more particles.
const std::vector<std::size_t>& many() {
    static const std::vector<std::size_t> sizes{32, 64, 128, 256, 512, 768};
    return sizes;
}
std::vector<report::Contestant> contestants(const Problem& problem, bool quick) {
    std::vector<report::Contestant> all;
    const auto add = [&](const Method<1>& method) {
        const bool slow = method.name == "alpha-beta" && problem.name == "wave" && !quick;
        all.push_back({method.name, method.label, method.styled(),
                       [run = problem.method, method](std::size_t n) { return run(method, n); },
                       slow ? many() : std::vector<std::size_t>{}});
    };
    for (const char* name : {"inutsuka", "varying-h", "godunov", "exact-riemann"}) add(line_methods()[name]);
    for (const char* name : {"alpha-beta", "narrow", "reconstructed"}) add(of_chapter_4(name));
    for (const shocks::Grid& grid : shocks::grids())
        all.push_back({grid.name, grid.label, grid.look,
                       [run = problem.grid, frame = grid.frame](std::size_t n) { return run(frame, n); },
                       problem.grid_sizes});
    return all;
}

double seconds(const std::vector<report::Track>& tracks, const std::string& name, double error) {
    using Kind = report::Reading::Kind;
    for (const report::Track& track : tracks) {
        if (track.who.name != name) continue;
        const report::Reading reading = track.seconds_at_error(error);
        if (reading.kind == Kind::value || reading.kind == Kind::at_most) return reading.value;
    }
    return std::numeric_limits<double>::infinity();
}
/// CPU seconds of one particle's step, at the last size.
double per_step(const std::vector<report::Track>& tracks, const std::string& name) {
    for (const report::Track& track : tracks) {
        if (track.who.name == name)
            return track.seconds.back() / (track.more.back()[0].value * static_cast<double>(track.n.back()));
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 1, 3};
    figure.panel_width = 290;
    std::vector<std::vector<std::string>> rows;
    for (const report::Contestant& who : contestants(problems()[0], true)) rows.push_back({who.label});
    std::vector<std::vector<report::Track>> all;
    int k = 0;
    for (Problem& problem : problems()) {
        plot::Panel& axes = figure.at(0, k)
                                .log_log()
                                .titled(problem.title)
                                .labels("CPU time [s]", "relative $L$_{1} error of " + problem.error_of);
        axes.legend.shown = k++ == 2;
        axes.legend.outside = true;
        if (run.quick()) problem.sizes.resize(2), problem.grid_sizes.resize(2);
        const auto& tracks = all.emplace_back(
            report::race(run, {.name = problem.name, .sizes = problem.sizes, .repeat_below = 0.02},
                         contestants(problem, run.quick())));
        report::draw_error_against_seconds(axes, tracks,
                                           {"inutsuka", "godunov", "alpha-beta", "reconstructed", "grid"});
        for (std::size_t row = 0; row < rows.size(); ++row)
            rows[row].push_back(tracks[row].seconds_at_error(problem.error).text(1e3));
    }
    run.save(figure);
    report::Table table{{"method", "Sod: ms to ρ 1 %", "blast: ms to ρ 3 %", "wave: ms to v 1 %"}};
    for (const auto& row : rows) table.row(row);
    run.fill("cost", table.markdown());
    const auto &sod = all[0], &wave = all[2];
    run.fill("cost-per-step", report::timing(per_step(sod, "godunov") / per_step(sod, "alpha-beta")));
    run.claim("cost-per-step",
              [&] { return run.checking() || per_step(sod, "godunov") < 2.2 * per_step(sod, "alpha-beta"); });
    run.claim("cost-wave", [&] {
        return run.checking() || seconds(wave, "alpha-beta", 0.01) > 50 * seconds(wave, "godunov", 0.01);
    });
    run.claim("answer", [&] {
        return run.checking() || (seconds(wave, "godunov", 0.01) < seconds(wave, "reconstructed", 0.01) &&
                                  seconds(sod, "godunov", 0.01) > seconds(sod, "grid", 0.01));
    });
    run.claim("cost-grid", [&] {
        return run.checking() || (seconds(sod, "godunov", 0.01) > 10 * seconds(sod, "grid", 0.01) &&
                                  seconds(wave, "godunov", 0.01) > 2 * seconds(wave, "grid", 0.01));
    });
}

}  // namespace sph::godunov
