#include <algorithm>

#include "chapters/03_euler_sph/scenes/rarefaction.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "common/exact/toy_star_modes.hpp"
#include "common/plot/method_looks.hpp"

/// One h for all, where the density falls to nothing.
namespace sph::euler {
namespace {

/// Four rows of errors against N.
struct Rows {
    plot::Values n, pulsation, own_pulsation, fan, own_fan;
};

Rows measure(report::Run& run, const std::vector<std::size_t>& sizes) {
    Rows rows;
    StarScene scene;
    scene.spacing = Spacing::even;
    const GasMethod one{"fixed-h", "cubic", 1.2}, own{"consistent-h", "cubic", 1.2};
    const auto frequency = [&](const GasMethod& method, int mode) {
        return star_frequencies(scene, method, 3)[static_cast<std::size_t>(mode - 1)] /
                   exact::toy_star_frequency(2, mode) -
               1;
    };
    for (const std::size_t size : sizes) {
        scene.n = size;
        RarefactionScene gas;
        gas.n = size;
        rows.n.push_back(static_cast<double>(size));
        rows.pulsation.push_back(std::abs(frequency(one, 2)));
        rows.own_pulsation.push_back(std::abs(frequency(own, 3)));
        rows.fan.push_back(run_rarefaction(gas, one).velocity_error);
        rows.own_fan.push_back(run_rarefaction(gas, own).velocity_error);
        run.record("fixed-h mode=2", size, {{"omega_error", rows.pulsation.back()}});
        run.record("consistent-h mode=3", size, {{"omega_error", rows.own_pulsation.back()}});
        run.record("fixed-h rarefaction", size, {{"l1_v", rows.fan.back()}});
        run.record("consistent-h rarefaction", size, {{"l1_v", rows.own_fan.back()}});
    }
    return rows;
}

void fill(report::Run& run, const Rows& rows) {
    if (run.quick()) return;
    report::Table table{{"h = 1.2 mean spacings", "N = 50", "N = 100", "N = 200", "N = 400"}};
    const auto row = [&](const std::string& label, const plot::Values& values) {
        std::vector<std::string> cells{label};
        for (const double value : values) cells.push_back(report::number(value, 2));
        table.row(cells);
    };
    row("one $h$: frequency of mode 2", rows.pulsation);
    row("own $h$: frequency of mode 3", rows.own_pulsation);
    row("one $h$: rarefaction, v", rows.fan);
    row("own $h$: rarefaction, v", rows.own_fan);
    run.fill("hard-case", table.markdown());
}

}  // namespace

void hard_case(report::Run& run) {
    plot::Figure figure{"hard-case", 1, 2};
    figure.panel_width = 330;
    plot::Panel& left = figure.at(0, 0)
                            .log_log()
                            .titled("frequency of a star's mode")
                            .labels("particles $N$", "| ω / ω_{exact} − 1 |");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("expansion into the vacuum")
                             .labels("particles $N$", "relative $L$_{1} error of $v$");
    const Rows rows = measure(run, run.sizes({50, 100}, {50, 100, 200, 400}));
    left.curve(rows.n, rows.pulsation, plot::look_of("fixed-h", "one $h$, mode 2"));
    left.curve(rows.n, rows.own_pulsation, plot::look_of("consistent-h", "own $h$, mode 3"));
    right.curve(rows.n, rows.fan, plot::look_of("fixed-h", "one $h$"));
    right.curve(rows.n, rows.own_fan, plot::look_of("consistent-h", "own $h$"));
    left.slope(-2, 100, 200, 3e-3, "order 2");
    right.slope(-1, 100, 200, 0.03, "order 1");
    for (plot::Panel* panel : {&left, &right}) panel->x.ticks = {50, 100, 200, 400};
    run.claim("one-h-never", [&] {
        return rows.pulsation.back() > 0.013 && rows.pulsation.back() > rows.pulsation.front() &&
               rows.fan.back() > rows.fan.front() && rows.own_pulsation.back() < 1e-4 &&
               rows.own_fan.back() < 0.002;
    });
    run.save(figure);
    fill(run, rows);
}

}  // namespace sph::euler
