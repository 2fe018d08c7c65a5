#include "chapters/03_euler_sph/scenes/necklace.hpp"
#include "common/report/chapter.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {
namespace {

NecklaceScene scene_of(const report::Run& run) {
    NecklaceScene scene;
    scene.threads = run.threads();
    if (run.quick()) scene.per_side = 32;
    return scene;
}

/// The largest change of the circulation against the number of tracers.
void convergence(report::Run& run, plot::Panel& panel) {
    const std::vector<std::size_t> counts =
        run.quick() ? std::vector<std::size_t>{64, 256} : std::vector<std::size_t>{64, 128, 256, 512, 1024};
    report::Table table{{"tracers", "with forces (3.34)", "carried"}};
    plot::Values count, drift, carried;
    for (const std::size_t tracers : counts) {
        NecklaceScene scene = scene_of(run);
        scene.tracers = tracers;
        scene.time = 1;
        const NecklaceRun flow = run_necklace(scene);
        count.push_back(static_cast<double>(tracers));
        drift.push_back(flow.drift);
        carried.push_back(flow.carried_drift);
        run.record("forces", tracers, {{"circulation_drift", flow.drift}});
        run.record("carried", tracers, {{"circulation_drift", flow.carried_drift}});
        table.row(
            {std::to_string(tracers), report::number(flow.drift, 1), report::number(flow.carried_drift, 1)});
    }
    panel.curve(count, drift, {.label = "forces", .colour = plot::cycle(0), .marker = plot::Marker::circle});
    panel.curve(count, carried,
                {.label = "carried", .colour = plot::cycle(1), .marker = plot::Marker::square});
    panel.slope(-2, 128, 512, 1e-5, "order 2");
    const double order = report::fitted_order(count, drift);
    run.record("forces", counts.back(), {{"rate_circulation_drift", order}});
    run.fill("necklace-order", report::fixed(order, 1));
    run.fill("necklace", table.markdown());
    run.claim("circulation-kept", [&] { return order > 1.9 && order < 2.1 && drift.back() < 2e-6; });
    run.claim("carried-lose",
              [&] { return carried.back() > 0.9 * carried.front() && carried.back() > 0.003; });
}

/// | C / C(0) - 1 |, what can be seen of it.
plot::Values change(const Column& circulation) {
    plot::Values values;
    for (std::size_t k = 1; k < circulation.size(); ++k)
        values.push_back(std::max(1e-12, std::abs(circulation[k] / circulation[0] - 1)));
    return values;
}

void draw_over_time(plot::Panel& panel, const NecklaceRun& flow, double h_over_dx, std::size_t colour) {
    const std::string with_h = ", $h$ = " + report::number(h_over_dx, 2) + " d$x$";
    const plot::Values t{flow.t.begin() + 1, flow.t.end()};
    panel.curve(t, change(flow.circulation), {.label = "forces" + with_h, .colour = plot::cycle(colour)});
    if (h_over_dx > 2)
        panel.curve(t, change(flow.carried), {.label = "carried" + with_h, .colour = plot::cycle(1)});
}

void draw_places(plot::Panel& panel, const NecklaceRun& flow) {
    const auto closed = [](Column values) {
        values.push_back(values.front());
        return values;
    };
    panel.curve(closed(flow.start[0]), closed(flow.start[1]),
                {.label = "$t$ = 0", .colour = plot::Colour{0.55, 0.55, 0.55}});
    panel.curve(closed(flow.end[0]), closed(flow.end[1]), {.label = "$t$ = 2", .colour = plot::cycle(0)});
}

}  // namespace

void necklace(report::Run& run) {
    plot::Figure figure{"necklace", 1, 3};
    figure.panel_width = 310;
    plot::Panel& left = figure.at(0, 0).titled("1024 tracers, $h$ = 2.5 d$x$").labels("$x$", "$y$");
    left.equal_aspect = true;
    plot::Panel& middle =
        figure.at(0, 1).log_y().titled("1024 tracers").labels("$t$", "| $C$ / $C$(0) − 1 |");
    plot::Panel& right =
        figure.at(0, 2).log_log().titled("until $t$ = 1").labels("tracers", "largest | $C$ / $C$(0) − 1 |");
    convergence(run, right);
    for (const double h_over_dx : {2.5, 1.5}) {
        NecklaceScene scene = scene_of(run);
        scene.h_over_dx = h_over_dx;
        const NecklaceRun flow = run_necklace(scene);
        draw_over_time(middle, flow, h_over_dx, h_over_dx == 2.5 ? 0 : 2);
        const std::string h = "h=" + report::number(h_over_dx, 2);
        run.record("forces " + h, scene.tracers, {{"circulation_drift", flow.drift}});
        run.record("gas " + h, scene.tracers, {{"energy_drift", flow.energy_drift}});
        if (h_over_dx == 2.5) {
            draw_places(left, flow);
            continue;
        }
        run.claim("necklace-wrinkles", [&] { return flow.drift > 0.1 && flow.energy_drift < 1e-3; });
    }
    middle.legend.outside = false;
    run.save(figure);
}

}  // namespace sph::euler
