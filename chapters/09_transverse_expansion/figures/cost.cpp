#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "chapters/09_transverse_expansion/scenes/rings_grid.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/norms.hpp"
#include "common/report/race.hpp"

/// What accuracy costs: the cylinder at tau = 15.
namespace sph::transverse {
namespace {

std::vector<report::Contestant> contestants(bool quick) {
    std::vector<report::Contestant> all;
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    for (const PlaneMethod& method :
         plane_methods().named({"hexagonal", "spiral-solved", "grad-h", "spiral-graded"})) {
        std::vector<std::size_t> sizes{625, 1250, 2500, 5000, 10000};
        if (method.name == plane_methods().recommended().name)
            sizes = {625, 1250, 2500, 5000, 10000, 20000, 40000};
        if (quick) sizes = {300, 600};
        all.push_back({method.name, method.label, method.styled(),
                       [flow, method](std::size_t n) -> report::Lap {
                           const Snapshot shot = run_plane(flow, {.n = n, .times = {15}}, method).back();
                           return {
                               shot.l1_temperature,
                               shot.seconds,
                               static_cast<double>(shot.counters.pairs),
                               {{"axis", shot.axis}, {"steps", static_cast<double>(shot.counters.steps)}}};
                       },
                       sizes});
    }
    all.push_back(
        {"grid", "grid on rings", plot::competitor("grid"),
         [flow](std::size_t n) -> report::Lap {
             const RingsRun rings = run_rings(flow, n, 15);
             return {rings.l1_temperature, rings.seconds, 0, {{"steps", static_cast<double>(rings.steps)}}};
         },
         quick ? std::vector<std::size_t>{25, 50} : std::vector<std::size_t>{25, 50, 100, 200, 400}});
    return all;
}

}  // namespace

void cost(report::Run& run) {
    const auto tracks =
        report::race(run, {.quantity = "l1_temperature", .repeats = 1}, contestants(run.quick()));
    plot::Figure figure{"cost", 1, 2};
    plot::Panel& size =
        figure.at(0, 0).log_log().labels("particles or rings", "relative $L$_{1} error of $T$, τ = 15");
    plot::Panel& time = figure.at(0, 1).log_log().labels("CPU time [s]", "");
    size.legend.shown = false;
    report::draw_error_against_size(size, tracks);
    report::draw_error_against_seconds(time, tracks);
    run.save(figure);
    using namespace report;
    Comparison table{{"method", "N"},
                     {{"L1 of T %", "l1_temperature", in_percent()},
                      {"order", "order", decimals(1), "–"},
                      {"axis %", "axis", in_percent(), "–"},
                      {"steps", "steps", whole()},
                      {"CPU s", "cpu_seconds", time_in(1)}}};
    for (const Track& track : tracks) {
        run.record(track.who.name, 0, {{"rate_l1_temperature", 2 * track.order()}});
        if (track.who.name != "spiral-graded" && track.who.name != "grid") continue;
        for (std::size_t k = 0; k < track.n.size(); ++k) {
            if (track.who.name == "grid" && k + 1 < track.n.size()) continue;
            Quantities lap = track.lap(k);
            const double per_length = track.who.name == "grid" ? 1 : 2;  // N ~ 1/dx, 1/dx^2
            if (k > 0)
                lap.push_back(
                    {"order",
                     per_length * observed_order(static_cast<double>(track.n[k - 1]), track.error[k - 1],
                                                 static_cast<double>(track.n[k]), track.error[k])});
            table.show({track.who.label, std::to_string(track.n[k])}, lap);
        }
    }
    run.fill("cost", table.markdown());
    const auto named = [&](const char* name) -> const Track& {
        return *std::find_if(tracks.begin(), tracks.end(),
                             [&](const Track& t) { return t.who.name == name; });
    };
    const Track& best = named("spiral-graded");
    run.fill("cost-order", fixed(2 * best.order(), 1));
    run.claim("cost-order", [&] { return 2 * best.order() > 0.8 && best.error.back() < 2.5e-3; });
    run.claim("cost-fast", [&] { return best.seconds[4] < 10; });
    run.claim("grid-wins", [&] {
        const Track& grid = named("grid");
        return grid.error.back() < best.error.back() && 50 * grid.seconds.back() < best.seconds[4] &&
               grid.error[2] < best.error[4] && 100 * grid.seconds[2] < best.seconds[4];
    });
}

}  // namespace sph::transverse
