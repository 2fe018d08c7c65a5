#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "common/report/norms.hpp"

namespace sph::shocks {

void wave(report::Run& run) {
    plot::Figure figure{"wave", 1, 2};
    plot::Panel& error_panel =
        figure.at(0, 1).log_log().labels("particles $N$", "relative $L$_{1} error of $v$");
    plot::Panel& energy_panel =
        figure.at(0, 0).log_log().labels("particles $N$", "energy of the wave lost in a period");
    const std::vector<std::size_t> sizes =
        run.quick() ? std::vector<std::size_t>{16, 32, 64} : std::vector<std::size_t>{16, 32, 64, 128, 256};
    report::Table table{{"method", "N = 16", "N = 32", "N = 64", "order", "α = 1 over it, N = 64"}};
    double of_alpha = 0;
    for (const std::string name :
         {"alpha-beta", "bulk", "signal", "thermokinetic", "morris-monaghan", "none", "reconstructed"}) {
        plot::Values n, error, lost;
        for (const std::size_t size : sizes) {
            StandingWave scene;
            scene.n = size;
            scene.threads = run.threads();
            const StandingWaveRun wave = run_standing_wave(scene, tube_method(name));
            n.push_back(static_cast<double>(size));
            error.push_back(wave.error);
            lost.push_back(1 - wave.energy_left);
            run.result(name, static_cast<long>(size), "l1_v", wave.error);
            run.result(name, static_cast<long>(size), "energy_lost", lost.back());
        }
        if (name == "alpha-beta") of_alpha = error[2];
        const double order = report::observed_order(n[0], error[0], n.back(), error.back());
        run.result(name, static_cast<long>(sizes.back()), "rate_l1_v", order);
        error_panel.curve(n, error, style_of(name));
        if (name != "none") energy_panel.curve(n, lost, style_of(name));
        table.row({tube_method(name).label, report::number(error[0], 2), report::number(error[1], 2),
                   report::number(error[2], 2), report::fixed(order, 1),
                   report::number(of_alpha / error[2], 2)});
        if (name == "reconstructed") run.fill("wave-gain", report::number(of_alpha / error[2], 2));
    }
    plot::Values n, error;
    for (const std::size_t size : sizes) {
        n.push_back(static_cast<double>(size));
        error.push_back(grid_standing_wave_error(size));
        run.result("grid", static_cast<long>(size), "l1_v", error.back());
    }
    error_panel.curve(n, error,
                      {.label = "grid", .colour = plot::Colour{0, 0, 0}, .marker = plot::Marker::cross});
    table.row({"grid, Eulerian", report::number(error[0], 2), report::number(error[1], 2),
               report::number(error[2], 2),
               report::fixed(report::observed_order(n[0], error[0], n.back(), error.back()), 1),
               report::number(of_alpha / error[2], 2)});
    energy_panel.legend.shown = false;
    error_panel.legend.outside = true;
    run.save(figure);
    run.fill("wave", table.markdown());
}

}  // namespace sph::shocks
