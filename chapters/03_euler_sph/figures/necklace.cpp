#include "chapters/03_euler_sph/scenes/necklace.hpp"
#include "chapters/03_euler_sph/scenes/patch.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {

void necklace(report::Run& run) {
    plot::Figure figure{"necklace", 1, 3};
    figure.panel_width = 310;
    plot::Panel& left = figure.at(0, 0).titled("the necklace at $t$ = 0 and 2").labels("$x$", "$y$");
    left.equal_aspect = true;
    plot::Panel& middle =
        figure.at(0, 1).log_y().titled("1024 tracers").labels("$t$", "| $C$ / $C$(0) − 1 |");
    plot::Panel& right =
        figure.at(0, 2).log_log().titled("until $t$ = 1").labels("tracers", "largest | $C$ / $C$(0) − 1 |");
    const std::vector<std::size_t> counts =
        run.quick() ? std::vector<std::size_t>{64, 256} : std::vector<std::size_t>{64, 128, 256, 512, 1024};
    report::Table table{{"tracers", "with forces (5.20)", "carried"}};
    plot::Values count, drift, carried;
    for (const std::size_t tracers : counts) {
        NecklaceScene scene;
        scene.tracers = tracers;
        scene.time = 1;
        scene.threads = run.threads();
        if (run.quick()) scene.per_side = 32;
        const NecklaceRun flow = run_necklace(scene);
        count.push_back(static_cast<double>(tracers));
        drift.push_back(flow.drift);
        carried.push_back(flow.carried_drift);
        run.result("forces", static_cast<long>(tracers), "circulation_drift", flow.drift);
        run.result("carried", static_cast<long>(tracers), "circulation_drift", flow.carried_drift);
        table.row({report::fixed(count.back(), 0), report::number(flow.drift, 1),
                   report::number(flow.carried_drift, 1)});
    }
    right.curve(count, drift, {.label = "with forces", .marker = plot::Marker::circle});
    right.curve(count, carried, {.label = "carried", .marker = plot::Marker::square});
    right.legend.shown = false;
    const double order = report::fitted_order(count, drift);
    run.result("forces", static_cast<long>(counts.back()), "rate_circulation_drift", order);
    run.fill("necklace-order", report::fixed(order, 1));
    for (const double h : {2.5, 1.5}) {
        NecklaceScene scene;
        scene.h = h;
        scene.threads = run.threads();
        if (run.quick()) scene.per_side = 32;
        const NecklaceRun flow = run_necklace(scene);
        const std::string with_h = ", $h$ = " + report::number(h, 2) + " d$x$";
        plot::Values t, C, c;
        for (std::size_t k = 1; k < flow.t.size(); ++k) {
            t.push_back(flow.t[k]);
            C.push_back(std::max(1e-12, std::abs(flow.circulation[k] / flow.circulation[0] - 1)));
            c.push_back(std::max(1e-12, std::abs(flow.carried[k] / flow.carried[0] - 1)));
        }
        const std::size_t index = h == 2.5 ? 0 : 2;
        middle.curve(t, C, {.label = "with forces" + with_h, .colour = plot::cycle(index)});
        middle.curve(
            t, c,
            {.label = "carried" + with_h, .colour = plot::cycle(index + 1), .dash = plot::Dash::dashed});
        run.result("forces h=" + report::number(h, 2), 1024, "circulation_drift", flow.drift);
        run.result("gas h=" + report::number(h, 2), 1024, "energy_drift", flow.energy_drift);
        if (h != 2.5) continue;
        const auto closed = [](Column values) {
            values.push_back(values.front());
            return values;
        };
        left.curve(closed(flow.start[0]), closed(flow.start[1]),
                   {.label = "$t$ = 0", .colour = plot::cycle(3)});
        left.curve(closed(flow.end[0]), closed(flow.end[1]), {.label = "$t$ = 2", .colour = plot::cycle(0)});
    }
    middle.legend.outside = false;
    run.save(figure);
    run.fill("necklace", table.markdown());
}

void patch(report::Run& run) {
    plot::Figure figure{"patch", 1, 3};
    figure.panel_width = 330;
    PatchScene scene;
    scene.threads = run.threads();
    if (run.quick()) scene.per_side = 24;
    const PatchRun liquid = run_patch(scene);
    const auto discs = [&](int column, const std::string& title, const Columns<2>& x, const Column& pressure,
                           bool bar) {
        plot::Panel& panel = figure.at(0, column).titled(title).labels("$x$", "$y$");
        panel.equal_aspect = true;
        panel.particles({.name = "pressure",
                         .x = x[0],
                         .y = x[1],
                         .value = pressure,
                         .diameter = 3.5,
                         .bar = {.label = "$P$ / ρ_{0}$V$^{2}",
                                 .map = plot::Map::blue_red,
                                 .range = std::array{-1.0, 1.0},
                                 .shown = bar}});
    };
    discs(0, "$t$ = 0.3 $L$/$V$", liquid.middle_x, liquid.middle_pressure, false);
    discs(1, "$t$ = 0.6 $L$/$V$", liquid.x, liquid.pressure, true);
    plot::Panel& right = figure.at(0, 2).titled("energy").labels("$t$ $V$/$L$", "10^{6} Δ$E$ / $E$");
    plot::Values change;
    for (const double value : liquid.energy) change.push_back(1e6 * value);
    right.curve(liquid.t, change, {.label = ""});
    run.save(figure);
    const auto n = static_cast<long>(scene.per_side * scene.per_side);
    run.result("phi-one", n, "energy_drift", liquid.energy_drift);
    run.result("phi-one", n, "momentum_drift", liquid.momentum);
    run.result("phi-one", n, "angular_momentum_drift", liquid.angular_momentum);
    run.result("phi-one", n, "compression", liquid.compression);
    run.result("phi-one", n, "steps", static_cast<double>(liquid.counters.steps));
    run.fill("patch-energy",
             liquid.energy_drift < 1e-7 ? "less than 10⁻⁷" : report::number(liquid.energy_drift, 1));
    run.fill("patch-compression", report::number(100 * liquid.compression, 1));
}

}  // namespace sph::euler
