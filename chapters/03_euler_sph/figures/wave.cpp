#include "chapters/03_euler_sph/figures/figures.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"
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
    const std::vector<std::size_t> sizes =
        run.quick() ? std::vector<std::size_t>{16, 32, 64} : std::vector<std::size_t>{16, 32, 64, 128, 256};
    report::Table table{{"h", "kernel", "h/dx", "N = 16", "N = 32", "N = 64", "order 16 to 64"}};
    for (const Named& named : compared_schemes()) {
        plot::Values n, error;
        for (const std::size_t size : sizes) {
            WaveScene scene;
            scene.n = size;
            scene.threads = run.threads();
            const WaveRun wave = run_wave(scene, named.scheme);
            n.push_back(static_cast<double>(size));
            error.push_back(wave.error);
            const auto count = static_cast<long>(size);
            run.result(named.name, count, "l1_v", wave.error);
            run.result(named.name, count, "momentum_drift", wave.momentum_drift);
            run.result(named.name, count, "pairs", static_cast<double>(wave.counters.pairs));
            run.result(named.name, count, "steps", static_cast<double>(wave.counters.steps));
            if (size != 64) continue;
            plot::Style line = named.style;
            line.marker = plot::Marker::none;
            left.curve(wave.t, wave.error_at, line);
        }
        right.curve(n, error, named.style);
        const double order = report::observed_order(n[0], error[0], n[2], error[2]);
        run.result(named.name, 64, "rate_l1_v", order);
        if (named.name == "super-gaussian") run.fill("wave-best", report::number(error[2], 1));
        table.row({named.label, named.scheme.kernel, report::number(named.scheme.h_over_dx, 3),
                   report::number(error[0], 2), report::number(error[1], 2), report::number(error[2], 2),
                   report::fixed(order, 1)});
    }
    left.legend.shown = false;
    right.legend.outside = true;
    run.save(figure);
    run.fill("wave", table.markdown());
}

}  // namespace sph::euler
