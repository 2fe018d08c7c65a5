#include <algorithm>

#include "chapters/08_landau_model/scenes/grid.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/norms.hpp"
#include "common/report/race.hpp"

/// What accuracy costs in the slab: error at t = 10 against particles and against CPU seconds.
namespace sph::landau {
namespace {

report::Lap lap(const SlabProfile& profile) {
    return {profile.l1_s_star, profile.seconds, 0, {{"steps", static_cast<double>(profile.counters.steps)}}};
}

std::vector<report::Contestant> contestants(bool quick) {
    std::vector<report::Contestant> all;
    for (const SlabMethod& method : slab_methods().named({"variable", "graded", "narrow", "narrow-graded"})) {
        const auto run = [method](std::size_t n) {
            return lap(run_slab({.n = n, .times = {10}, .courant = SlabScene::fast_courant}, method).back());
        };
        std::vector<std::size_t> sizes{30, 60, 125, 250, 500};
        if (method.name == slab_methods().recommended().name) sizes = {60, 125, 250, 500, 1000, 2000};
        if (quick) sizes = {60, 125};
        all.push_back({method.name, method.label, method.styled(), run, sizes});
    }
    all.push_back(
        {"grid", "grid", plot::competitor("grid"),
         [](std::size_t n) { return lap(run_grid_slab(n, {10}).back()); },
         quick ? std::vector<std::size_t>{50, 100} : std::vector<std::size_t>{50, 100, 200, 400, 800, 1600}});
    return all;
}

void add_rows(report::Comparison& table, const report::Track& track) {
    const plot::Values n = track.sizes();
    for (std::size_t k = 0; k < n.size(); ++k) {
        report::Quantities lap = track.lap(k);
        if (k > 0)
            lap.push_back(
                {"order", report::observed_order(n[k - 1], track.error[k - 1], n[k], track.error[k])});
        table.show({track.who.label, std::to_string(track.n[k])}, lap);
    }
}

const report::Track& track_of(const std::vector<report::Track>& tracks, const std::string& name) {
    return *std::find_if(tracks.begin(), tracks.end(), [&](const auto& one) { return one.who.name == name; });
}

void assert_text(report::Run& run, const std::vector<report::Track>& tracks) {
    const auto &plain = track_of(tracks, "variable"), &best = track_of(tracks, "narrow-graded"),
               &grid = track_of(tracks, "grid");
    const auto error_at = [](const report::Track& track, std::size_t n) {
        const auto k = std::find(track.n.begin(), track.n.end(), n) - track.n.begin();
        return track.error.at(static_cast<std::size_t>(k));
    };
    run.claim("slab-orders", [&] {
        return plain.order() > 0.85 && plain.order() < 1.05 && best.order() > 1.15 && best.order() < 1.45;
    });
    run.claim("slab-fewer", [&] { return error_at(best, 125) < error_at(plain, 500) / 2; });
    run.claim("slab-grid", [&] {
        const double error = error_at(best, 1000);
        return error_at(grid, 800) / error < 1.1 && error_at(grid, 400) / error > 1.1 &&
               best.seconds_at_error(error * 1.001).value > 30 * grid.seconds_at_error(error * 1.001).value;
    });
}

}  // namespace

void slab_cost(report::Run& run) {
    plot::Figure figure{"slab-cost", 1, 2};
    plot::Panel& convergence =
        figure.at(0, 0).log_log().labels("particles or cells", "relative $L$_{1} error of $s$*, $t$ = 10");
    plot::Panel& cost = figure.at(0, 1).log_log().labels("CPU time [s]", "");
    cost.legend.shown = false;
    using namespace report;
    Comparison table{{"method", "N"},
                     {{"relative L1 of s*", "l1_s_star", digits(2)},
                      {"order", "order", decimals(1), "–"},
                      {"steps", "steps", whole()},
                      {"CPU ms", "cpu_seconds", time_in(1e-3)}}};
    const auto tracks = report::race(run, {.quantity = "l1_s_star", .repeats = 1}, contestants(run.quick()));
    for (const report::Track& track : tracks) {
        run.record(track.who.name, 0, {{"rate_l1_s_star", track.order()}});
        add_rows(table, track);
    }
    report::draw_error_against_size(convergence, tracks);
    report::draw_error_against_seconds(cost, tracks);
    convergence.slope(-1, 200, 1000, 0.04, "order 1");
    run.save(figure);
    run.fill("slab-cost", table.markdown());
    assert_text(run, tracks);
}

}  // namespace sph::landau
