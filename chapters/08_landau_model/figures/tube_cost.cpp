#include "chapters/08_landau_model/scenes/grid.hpp"
#include "chapters/08_landau_model/figures/figures.hpp"

/// What accuracy costs in the two blasts.
namespace sph::landau {

void tube_cost(report::Run& run) {
    plot::Figure figure{"tube-cost", 1, 2};
    report::Table table{{"problem", "method", "N", "ρ %", "v %", "shock %", "steps", "CPU ms"}};
    for (int which = 1; which <= 2; ++which) {
        plot::Panel& axes = figure.at(0, which - 1)
                                .log_log()
                                .titled("problem " + std::to_string(which))
                                .labels("CPU time [s]", which == 1 ? "relative $L$_{1} error of ρ" : "");
        axes.legend.shown = which == 1;
        const std::vector<std::size_t> full = which == 1 ? std::vector<std::size_t>{50, 100, 200, 400, 800}
                                                         : std::vector<std::size_t>{40, 80, 120, 160, 240};
        const std::vector<std::size_t> sizes =
            run.quick() ? std::vector<std::size_t>{full[0], full[1]} : full;
        const auto series = [&](const std::string& name, const std::string& label, const plot::Style& style,
                                std::size_t finer, auto&& one) {
            plot::Values seconds, error;
            for (const std::size_t n : sizes) {
                TubeScene scene = problem(which);
                scene.n = n * finer;
                const RelativisticTubeRun result = one(scene);
                seconds.push_back(result.seconds), error.push_back(result.l1_rho);
                const std::string row = "problem " + std::to_string(which) + " " + name;
                run.result(row, static_cast<long>(scene.n), "l1_rho", result.l1_rho);
                run.result(row, static_cast<long>(scene.n), "cpu_seconds", result.seconds, "s");
                table.row({std::to_string(which), label, std::to_string(scene.n),
                           report::number(100 * result.l1_rho, 2), report::number(100 * result.l1_v, 2),
                           report::number(100 * result.shock_error, 2), std::to_string(result.counters.steps),
                           report::timing(1e3 * result.seconds)});
            }
            axes.curve(seconds, error, style);
        };
        std::size_t k = 0;
        for (const char* name : {"chow-monaghan", "reconstructed"}) {
            const Method& method = relativistic_method(name);
            series(method.name, method.label,
                   {.label = method.label, .colour = plot::cycle(k++), .marker = plot::Marker::circle}, 1,
                   [&](const TubeScene& scene) { return run_relativistic_tube(scene, method); });
        }
        series("grid", "grid", grid_line(), 2,
               [](const TubeScene& scene) { return run_grid_relativistic_tube(scene); });
    }
    run.save(figure);
    run.fill("tube-cost", table.markdown());
}

}  // namespace sph::landau
