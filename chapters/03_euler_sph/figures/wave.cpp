#include "chapters/03_euler_sph/scenes/wave.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {

void wave(report::Run& run) {
    plot::Figure figure{"wave", 1, 2};
    plot::Panel& left =
        figure.at(0, 0).log_y().titled("$N$ = 64").labels("$t$ / period", "relative $L$_{1} error of $v$");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("largest error over a period")
                             .labels("particles $N$", "relative $L$_{1} error of $v$");
    const auto sizes = run.sizes({16, 32, 64}, {16, 32, 64, 128, 256});
    report::Table table{{"h", "kernel", "h/dx", "N = 16", "N = 32", "N = 64", "order 16 to 64"}};
    for (const GasMethod& method : compared_methods()) {
        plot::Values n, error;
        for (const std::size_t size : sizes) {
            WaveScene scene;
            scene.n = size;
            scene.threads = run.threads();
            const WaveRun wave = run_wave(scene, method);
            n.push_back(static_cast<double>(size));
            error.push_back(wave.error);
            run.record(method.name, size, wave.measured());
            if (size == 64) left.curve(wave.t, wave.error_at, plot::line(method.look));
        }
        right.curve(n, error, method.look);
        const double order = report::observed_order(n[0], error[0], n[2], error[2]);
        run.record(method.name, 64, {{"rate_l1_v", order}});
        if (method.name == "super-gaussian") run.fill("wave-best", report::number(error[2], 1));
        table.row({method.label, method.kernel, report::number(method.h_over_dx, 3),
                   report::number(error[0], 2), report::number(error[1], 2), report::number(error[2], 2),
                   report::fixed(order, 1)});
    }
    left.legend.shown = false;
    right.legend.outside = true;
    run.save(figure);
    run.fill("wave", table.markdown());
}

}  // namespace sph::euler
