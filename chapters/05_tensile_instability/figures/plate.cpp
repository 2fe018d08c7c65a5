#include <cmath>
#include <map>
#include <numbers>

#include "chapters/05_tensile_instability/scenes/plate.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/norms.hpp"

namespace sph::tensile {
namespace {

/// Half a swing of 4 rows, by several laws.
std::map<std::string, double> draw_swings(report::Run& run, plot::Panel& panel) {
    std::map<std::string, double> frequency;
    PlateScene scene;
    scene.rows = 4;
    scene.threads = run.threads();
    // Both laws with many and with few neighbours.
    const std::vector<SolidMethod> methods{solid_methods()["jaumann"], with_h("jaumann", "narrow", 0.75),
                                           with_h("total-lagrangian", "wide", 1.5),
                                           solid_methods()["total-lagrangian"]};
    for (const SolidMethod& method : methods) {
        const PlateRun plate = run_plate(scene, method);
        frequency[method.name] = plate.frequency;
        run.record(method.name, scene.rows, plate.measured());
        const double omega = exact_plate(scene).omega(1);
        plot::Values at, swing;
        for (std::size_t k = 0; k < plate.t.size(); k += 20) {
            at.push_back(plate.t[k]);
            swing.push_back(plate.swing[k] * omega / scene.speed);
        }
        panel.curve(at, swing, plot::line(plot::look_of(method.name, method.label)));
    }
    plot::draw_exact(
        panel, 0, 0.5, [](double t) { return std::sin(2 * std::numbers::pi * t); },
        plot::exact("thin-plate theory"));
    return frequency;
}

}  // namespace

void plate(report::Run& run) {
    plot::Figure figure{"plate", 1, 2};
    plot::Panel& swings =
        figure.at(0, 0).titled("half a swing, 4 rows").labels("$t$ / exact period", "first mode ω / $v$_{0}");
    plot::Panel& errors = figure.at(0, 1)
                              .log_log()
                              .titled("total Lagrangian")
                              .labels("rows across the plate", "relative error");
    auto frequency = draw_swings(run, swings);
    const SolidMethod& method = solid_methods().recommended();
    plot::Values rows, of_frequency, of_deflection;
    report::Table table{{"rows", "frequency / theory", "deflection / theory"}};
    PlateScene scene;
    scene.threads = run.threads();
    for (const std::size_t count : run.sizes({3, 4}, {4, 6, 8})) {
        scene.rows = count;
        const PlateRun swing = run_plate(scene, method);
        const BeamRun beam = run_beam(scene);
        run.record("total-lagrangian", count, swing.measured());
        run.record("total-lagrangian beam", count, beam.measured());
        rows.push_back(static_cast<double>(count));
        of_frequency.push_back(std::abs(swing.frequency - 1));
        of_deflection.push_back(std::abs(beam.deflection - 1));
        table.row(
            {std::to_string(count), report::fixed(swing.frequency, 4), report::fixed(beam.deflection, 4)});
    }
    errors.curve(rows, of_frequency, plot::look_of("total-lagrangian", "first frequency"));
    errors.curve(
        rows, of_deflection,
        {.label = "deflection under load", .colour = plot::cycle(6), .marker = plot::Marker::square});
    errors.slope(-2, rows.front(), rows.back(), 0.8 * of_frequency.front(), "order 2");
    run.save(figure);
    run.fill("plate", table.markdown());
    run.claim("plate-within-three-percent", [&] {
        return of_frequency[0] < 0.03 && of_frequency[1] < 0.6 * of_frequency[0] &&
               of_frequency[2] < 0.7 * of_frequency[1];
    });
    run.claim("plate-wide-soft",
              [&] { return frequency["jaumann"] < 0.8 && frequency["total-lagrangian-wide"] < 0.8; });
    run.claim("plate-narrow-right", [&] { return std::abs(frequency["jaumann-narrow"] - 1) < 0.03; });
    run.claim("beam-converges", [&] {
        return of_deflection[1] < 0.7 * of_deflection[0] && of_deflection[2] < 0.8 * of_deflection[1];
    });
}

}  // namespace sph::tensile
