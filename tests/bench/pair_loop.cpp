#include <stdexcept>

#include "tests/bench/benches.hpp"
#include "tests/bench/peaks.hpp"
#include "tests/bench/race.hpp"
#include "tests/bench/rivals.hpp"

/// The fused pass (density, continuity, pressure, heating, viscosity) by this project's tile loop and by the
/// ways in which it is usually written, from the same particles, one thread.
namespace bench {
namespace {

/// A rival that computes something else would make the comparison worthless.
template <int d>
void require_equal(const std::string& name, const Rivals<d>& rivals, const Gas<d>& gas) {
    const double difference = rivals.worst_difference(gas.particles);
    if (!(difference < 1e-10))
        throw std::runtime_error{name + ": differs from the engine by " + report::number(difference, 2)};
}

struct Method {
    std::string name, label;
    double pairs_per_second = 0, median = 0;
};

template <int d>
std::vector<Method> measure_methods(report::Run& run, Gas<d>& gas) {
    Rivals<d> rivals{gas};
    const auto pass = [&] { gas.sum(all_forces()); };
    pass();
    const std::vector<Runner> ways{{"naive", [&] { rivals.linked_list(); }},
                                   {"sorted", [&] { rivals.sorted_cells(); }},
                                   {"list", [&] { rivals.from_list(); }},
                                   {"half-list", [&] { rivals.from_half_list(); }},
                                   {"tiles", pass},
                                   {"tiles-without-list",
                                    [&] {
                                        gas.find(sph::Keep::nothing);
                                        gas.sum(all_forces());
                                    }},
                                   {"tiles-and-list", [&] {
                                        gas.find();
                                        gas.sum(all_forces());
                                    }}};
    const std::vector<std::string> labels{"structures, linked list in cells",
                                          "structures sorted by cell",
                                          "sorted structures, ready list",
                                          "sorted structures, ready half list",
                                          "**tiles, ready list**",
                                          "tiles, sorting and finding, no list",
                                          "tiles, sorting and listing"};
    for (std::size_t k = 0; k < 4; ++k) {
        ways[k].work();
        require_equal(ways[k].name, rivals, gas);
    }
    // Each way leaves the list as the next one wants it: the one without a list is followed by one that makes
    // it.
    const std::vector<Lap> laps = race(run, ways);
    gas.find();
    const auto pairs = static_cast<double>(gas.neighbours.pairs());
    std::vector<Method> methods;
    for (std::size_t k = 0; k < ways.size(); ++k)
        methods.push_back({ways[k].name, labels[k], pairs / laps[k].best, pairs / laps[k].median});
    return methods;
}

struct Case {
    std::size_t per_side;
    double h_over_dx;
};

template <int d>
void pair_loop(report::Run& run, const std::vector<Case>& cases) {
    const std::string name = "pair_loop_" + std::to_string(d) + "d";
    plot::Figure figure{name, 1, static_cast<int>(cases.size())};
    figure.panel_width = 400;
    figure.panel_height = 260;
    const Peaks peaks = measure_peaks(run.quick());
    std::vector<std::string> header{"one pass of all forces, " + std::to_string(d) + "D"};
    std::vector<std::vector<std::string>> rows;
    int column = 0;
    for (const Case& which : cases) {
        Gas<d> gas{which.per_side, which.h_over_dx};
        gas.find();
        const std::vector<Method> methods = measure_methods(run, gas);
        const auto n = static_cast<long>(gas.particles.size());
        const double neighbours = gas.neighbours_each();
        const std::string tag = cases.size() == 1 ? "" : " " + report::fixed(neighbours, 0) + " neighbours";
        header.push_back(report::fixed(neighbours, 0) + " neighbours: 10⁶ pairs/s");
        header.emplace_back("naive = 1");
        plot::Panel& panel = figure.at(0, column++).titled(report::fixed(neighbours, 0) + " neighbours");
        panel.labels("million pairs a second", "").x_range(0, 1.15e-6 * methods[4].pairs_per_second);
        panel.legend.shown = false;
        rows.resize(methods.size());
        for (std::size_t k = 0; k < methods.size(); ++k) {
            const Method& m = methods[k];
            const bool tiles = m.name.rfind("tiles", 0) == 0;
            run.result(m.name + tag, n, "pairs_per_second", m.pairs_per_second, "1/s");
            run.result(m.name + tag, n, "median_pairs_per_second", m.median, "1/s");
            if (rows[k].empty()) rows[k].push_back(m.label);
            rows[k].push_back(report::timing(1e-6 * m.pairs_per_second, 3));
            rows[k].push_back(report::timing(m.pairs_per_second / methods[0].pairs_per_second));
            const double y = static_cast<double>(methods.size() - k);
            panel.band({0, 1e-6 * m.pairs_per_second}, {y - 0.2, y - 0.2}, {y + 0.2, y + 0.2}).colour =
                plot::cycle(tiles ? 0 : 1);
            panel.y.ticks.push_back(y);
            panel.y.tick_names.push_back(column == 1 ? m.name : "");
        }
        panel.y_range(0.4, static_cast<double>(methods.size()) + 0.6);
        panel.grid = false;
        const double rate = methods[4].pairs_per_second;
        // Read at least once from memory: the list, a row written and read, the columns and the results.
        const double bytes_a_pair = 4 + (2 * 8.0 * (d == 3 ? 12 : 8) + 8.0 * (3 * d + 8)) / neighbours;
        run.result("tiles" + tag, n, "neighbours", neighbours);
        run.result("tiles" + tag, n, "fraction_of_fma_peak", rate * operations_a_pair<d> / peaks.flops);
        run.result("tiles" + tag, n, "fraction_of_memory_bandwidth", rate * bytes_a_pair / peaks.bytes);
        run.fill("bench-peaks-" + std::to_string(d) + "d" + (column == 1 ? "" : "-more"),
                 report::timing(100 * rate * operations_a_pair<d> / peaks.flops) + " % of its " +
                     report::timing(1e-9 * peaks.flops, 3) + " GFLOP/s, " +
                     report::timing(100 * rate * bytes_a_pair / peaks.bytes) + " % of its " +
                     report::timing(1e-9 * peaks.bytes) + " GB/s");
    }
    report::Table table{header};
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("bench-pair-loop-" + std::to_string(d) + "d", table.markdown());
}

}  // namespace

void pair_loop_2d(report::Run& run) {
    const std::size_t side = run.quick() ? 60 : 316;
    pair_loop<2>(run, {{side, 1.2}, {side, 2.13}});
}
void pair_loop_3d(report::Run& run) {
    pair_loop<3>(run, {{run.quick() ? std::size_t{14} : 46, 1.185}});
}

}  // namespace bench
