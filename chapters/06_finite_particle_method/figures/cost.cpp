#include <algorithm>
#include <map>

#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"
#include "common/report/race.hpp"

/// What accuracy costs: the steps of whole runs, in CPU seconds of one thread.
namespace sph::fpm {
namespace {

report::Lap lap(const BurgersScene& given, std::size_t n, double viscosity) {
    BurgersScene scene = given;
    scene.n = n, scene.viscosity = viscosity;
    const BurgersRun line = run_burgers(scene);
    if (line.first_crossing >= 0)
        throw Unstable{line.first_crossing, Unstable::no_particle, "the order of particles", 0};
    return {line.errors.back().linf, line.seconds};
}

report::Contestant contestant(const LineMethod& method, double viscosity, double jitter,
                              std::vector<std::size_t> sizes) {
    BurgersScene scene = method.on({});
    scene.jitter = jitter;
    if (jitter > 0) scene.h_over_dx = 1.5;
    return {method.name + (jitter > 0 ? "-jittered" : ""), method.label + (jitter > 0 ? ", jittered" : ""),
            method.styled(), [scene, viscosity](std::size_t n) { return lap(scene, n, viscosity); },
            std::move(sizes)};
}

std::string table_of(const std::vector<report::Track>& tracks, const std::vector<double>& bounds) {
    std::vector<std::string> header{"method"};
    for (const double bound : bounds) header.push_back("ms to " + report::number(bound, 1));
    report::Table table{header};
    for (const report::Track& track : tracks) {
        std::vector<std::string> row{track.who.label};
        for (const double bound : bounds) row.push_back(track.seconds_at_error(bound).text(1e3));
        table.row(row);
    }
    return table.markdown();
}

const report::Track& of(const std::vector<report::Track>& tracks, const std::string& name) {
    return *std::find_if(tracks.begin(), tracks.end(),
                         [&](const report::Track& track) { return track.who.name == name; });
}
double seconds(const std::vector<report::Track>& tracks, const std::string& name, double bound) {
    const report::Reading reading = of(tracks, name).seconds_at_error(bound);
    using Kind = report::Reading::Kind;
    const bool read = reading.kind == Kind::value || reading.kind == Kind::at_most;
    return read ? reading.value : std::numeric_limits<double>::infinity();
}

std::vector<report::Track> race_still(report::Run& run, plot::Panel& panel) {
    const auto sizes = run.sizes({11, 21}, {11, 15, 21, 41, 81});
    const auto more = run.sizes({11, 21}, {11, 21, 41, 81, 161});
    std::vector<report::Contestant> all;
    for (const char* name : {"sph", "brookshaw", "cspm", "fpm", "taylor", "sfpm-4", "fdm-4"})
        all.push_back(contestant(still_methods()[name], 1, 0, sizes));
    for (const char* name : {"sfpm", "fdm"}) all.push_back(contestant(still_methods()[name], 1, 0, more));
    report::Contestant jittered = contestant(still_methods()["sfpm-4"], 1, 0.2, sizes);
    jittered.look.dash = plot::Dash::dashed;
    all.push_back(jittered);
    // Relative to the largest u, which is small at t = 1.
    const auto tracks =
        report::race(run, {.name = "still", .sizes = sizes, .quantity = "linf_u", .repeat_below = 0.1}, all);
    report::draw_error_against_seconds(panel, tracks, {"sph", "sfpm", "sfpm-4", "fdm", "fdm-4"});
    return tracks;
}

std::vector<report::Track> race_moving(report::Run& run, plot::Panel& panel) {
    const auto sizes = run.sizes({50, 70}, {35, 50, 70, 100, 140});
    constexpr double viscosity = 0.02;
    std::vector<report::Contestant> all;
    for (const char* name : {"taylor", "remesh-fit", "remesh-m4", "frame-2", "frame-4"})
        all.push_back(contestant(moving_methods()[name], viscosity, 0, sizes));
    const auto grid = run.sizes({26, 51}, {36, 51, 101, 201, 401, 801});
    for (const char* name : {"fdm", "fdm-4"})
        all.push_back(contestant(still_methods()[name], viscosity, 0, grid));
    const auto tracks =
        report::race(run, {.name = "moving", .sizes = sizes, .quantity = "linf_u", .repeat_below = 0.1}, all);
    report::draw_error_against_seconds(panel, tracks, {"taylor", "remesh-fit", "frame-4", "fdm", "fdm-4"});
    return tracks;
}

/// Seconds of the two schemes that hold at gamma = 0.005, 100 particles: the least of five.
double price_of_frame(report::Run& run) {
    std::map<std::string, double> least;
    for (const char* name : {"remesh-fit", "frame-4"}) {
        BurgersScene scene = moving_methods()[name].on({});
        scene.viscosity = 0.005;
        least[name] = std::numeric_limits<double>::infinity();
        for (int k = 0; k < (run.quick() || run.checking() ? 1 : 5); ++k)
            least[name] = std::min(least[name], run_burgers(scene).seconds);
        run.record(name, 100, {{"cpu_seconds", least[name], "s"}});
    }
    return least["frame-4"] / least["remesh-fit"];
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 1, 2};
    plot::Panel& left = figure.at(0, 0).log_log().titled("still, γ = 1");
    plot::Panel& right = figure.at(0, 1).log_log().titled("moving, γ = 0.02");
    for (plot::Panel* panel : {&left, &right})
        panel->labels("CPU time [s]", "largest error of $u$ at $t$ = 1");
    const auto still = race_still(run, left), moving = race_moving(run, right);
    const double ratio = price_of_frame(run);
    run.fill("frame-price", report::timing(ratio, 1));
    run.fill("cost-still", table_of(still, {0.02, 1e-3, 1e-5}));
    run.fill("cost-moving", table_of(moving, {1e-2, 1e-3, 1e-4, 1e-5}));
    run.claim("frame-price", [&] { return run.checking() || ratio < 10; });
    run.claim("fourth-order-pays", [&] {
        return run.checking() || (seconds(still, "fdm", 1e-3) > 10 * seconds(still, "sfpm-4", 1e-3) &&
                                  seconds(still, "sfpm-4", 1e-5) < 3 * seconds(still, "fdm-4", 1e-5) &&
                                  seconds(still, "fdm-4", 1e-5) < 3 * seconds(still, "sfpm-4", 1e-5));
    });
    run.claim("second-order-loses", [&] {
        bool slower = true;
        for (const char* name : {"sph", "cspm", "fpm", "sfpm", "taylor"})
            slower = slower && seconds(still, name, 0.02) > 1.5 * seconds(still, "fdm", 0.02);
        return run.checking() || slower;
    });
    run.claim("grid-wins-moving", [&] {
        return run.checking() || (seconds(moving, "frame-4", 1e-4) > 5 * seconds(moving, "fdm-4", 1e-4) &&
                                  seconds(moving, "frame-4", 1e-3) < seconds(moving, "remesh-fit", 1e-3) &&
                                  seconds(moving, "frame-4", 1e-3) < seconds(moving, "taylor", 1e-3));
    });
    run.save(figure);
}

}  // namespace sph::fpm
