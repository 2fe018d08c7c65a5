#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/exact/burgers.hpp"
#include "common/plot/looks.hpp"

/// Still particles at three viscosities (Ye et al. 2019, figure 1).
namespace sph::fpm {

void profiles(report::Run& run) {
    plot::Figure figure{"profiles", 1, 3};
    const std::vector<std::string> names{"sph", "sfpm", "sfpm-4", "fdm"};
    report::Table table{{"method", "γ = 0.1: largest error", "γ = 0.02", "γ = 0.005"}};
    std::vector<std::vector<std::string>> rows;
    for (const std::string& name : names) rows.push_back({still_methods()[name].label});
    int column = 0;
    std::vector<double> fourth, second;
    for (const double viscosity : {0.1, 0.02, 0.005}) {
        plot::Panel& panel = figure.at(0, column).titled("γ = " + written(viscosity));
        panel.labels("$x$", "$u$ at $t$ = 0.5").x_range(0.6, 1).y_range(-0.25, 1.4);
        panel.legend.shown = column++ == 0;
        const exact::Burgers exact{viscosity};
        plot::draw_exact(panel, 0.6, 1, [&](double x) { return exact.velocity(x, 0.5); });
        for (std::size_t k = 0; k < names.size(); ++k) {
            const LineMethod& method = still_methods()[names[k]];
            BurgersScene scene = method.on({});
            scene.n = 81, scene.viscosity = viscosity, scene.time = 0.5;
            const BurgersRun line = run_burgers(scene);
            panel.points(line.x, line.u, plot::dots(method.styled(), 4));
            run.record(names[k] + " gamma " + written(viscosity), scene.n, line.measured());
            rows[k].push_back(report::number(line.errors.back().linf, 2));
            if (names[k] == "sfpm-4") fourth.push_back(line.errors.back().linf);
            if (names[k] == "sfpm") second.push_back(line.errors.back().linf);
        }
    }
    for (const auto& row : rows) table.row(row);
    run.fill("profiles", table.markdown());
    run.claim(
        "layer-needs-points",
        [&] { return fourth[0] < 1e-5 && fourth[1] < 1e-2 && fourth[2] > 0.05 && second[2] > 3 * fourth[2]; },
        report::Needs::any_run);
    run.save(figure);
}

}  // namespace sph::fpm
