#include "chapters/03_euler_sph/scenes/wave.hpp"

#include <cmath>
#include <map>

#include "chapters/03_euler_sph/dispersion.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {
namespace {

using Errors = std::map<std::string, plot::Values>;  // against N = 16, 32, 64, 128, 256

void claims(report::Run& run, const Errors& errors) {
    run.claim("one-h-wave", [&] {
        const auto& one = errors.at("fixed-h");
        return one.back() > one.front() && std::abs(one[4] / one[3] - 1) < 0.02;
    });
    run.claim("without-omega-wave", [&] {
        // c_s of long waves, by the dispersion relation.
        const double h = 1.2, k = 0.01, gamma = 1.4;
        const double c_s = std::sqrt(dispersion<CubicSpline<1>>(h, gamma, k).without_omega) / k;
        bool all = std::abs(c_s / std::sqrt(1 + lattice_slope<CubicSpline<1>>(h)) - 1) < 2e-4;
        for (const char* name : {"averaged-h", "without-omega"}) {
            const auto& error = errors.at(name);
            all = all && error.back() > 0.05 && std::abs(error[4] / error[3] - 1) < 0.03;
        }
        return all;
    });
    run.claim("wave-floors", [&] {
        const auto &cubic = errors.at("consistent-h"), &super = errors.at("super-gaussian");
        return cubic[1] / cubic[2] > 3.5 && cubic[3] / cubic[4] < 2.3 && super[0] / super[1] > 14 &&
               super[4] > super[3];
    });
    run.claim("super-gaussian-wave",
              [&] { return errors.at("super-gaussian")[2] < errors.at("consistent-h")[2] / 100; });
}

/// After some periods, when the errors of the speed have added up, and at an eighth of one more: at its ends
/// and middle a standing wave does not show them.
void draw_wave(plot::Panel& panel) {
    WaveScene scene;
    scene.n = 32;
    scene.periods = 5.125;
    plot::draw_exact(panel, 0, 1,
                     [&](double x) { return scene.velocity(x, scene.periods) / scene.amplitude; });
    for (const GasMethod& method : compared_methods()) {
        if (method.name == "averaged-h" || method.name == "without-omega") continue;
        const WaveRun wave = run_wave(scene, method);
        plot::Values v;
        for (const double value : wave.v) v.push_back(value / scene.amplitude);
        panel.points(wave.x, v, plot::dots(method.look, 5));
    }
}

}  // namespace

void wave(report::Run& run) {
    plot::Figure figure{"wave", 1, 2};
    plot::Panel& left =
        figure.at(0, 0).titled("after 5⅛ periods, $N$ = 32").labels("$x$", "$v$ / amplitude").x_range(0, 1);
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("largest error over a period")
                             .labels("particles $N$", "relative $L$_{1} error of $v$");
    right.x.ticks = {16, 32, 64, 128, 256};
    draw_wave(left);
    const auto sizes = run.sizes({16, 32, 64}, {16, 32, 64, 128, 256});
    report::Table table{{"h", "kernel", "h/dx", "N = 16", "N = 32", "N = 64", "order 16 to 64"}};
    Errors errors;
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
        }
        right.curve(n, error, method.look);
        errors[method.name] = error;
        const double order = report::observed_order(n[0], error[0], n[2], error[2]);
        run.record(method.name, 64, {{"rate_l1_v", order}});
        if (method.name == "super-gaussian") run.fill("wave-best", report::number(error[2], 1));
        table.row({method.label, method.kernel, report::number(method.h_over_dx, 3),
                   report::number(error[0], 2), report::number(error[1], 2), report::number(error[2], 2),
                   report::fixed(order, 1)});
    }
    left.legend.shown = false;
    right.slope(-2, 32, 64, 0.01, "order 2");
    right.slope(-4, 32, 64, 3e-4, "order 4");
    right.legend.outside = true;
    run.save(figure);
    run.fill("wave", table.markdown());
    claims(run, errors);
}

}  // namespace sph::euler
