#include "chapters/05_tensile_instability/scenes/regularisation.hpp"
#include "chapters/05_tensile_instability/figures/kernel_looks.hpp"

#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "common/report/chapter.hpp"

namespace sph::tensile {
namespace {

DisorderRun run_of(const report::Run& run, const std::string& kernel, double h, double friction) {
    DisorderedBox scene{.friction = friction, .time = run.quick() ? 20.0 : 40.0};
    scene.box.kernel = kernel, scene.box.h_over_dx = h;
    scene.box.seed = run.seed(), scene.box.threads = run.threads();
    return run_disorder(scene);
}

void draw_histories(plot::Panel& panel, const DisorderRun& free, const DisorderRun& damped,
                    const DisorderRun& paired) {
    panel.titled("cubic spline, $P$ = 0.2").labels("$t c$ / d$x$", "disorder / d$x$").log_y();
    panel.curve(free.t, free.measured, {.label = "$h$ = 1.2 d$x$, no friction", .colour = plot::cycle(0)});
    panel.curve(damped.t, damped.measured,
                {.label = "$h$ = 1.2 d$x$, with friction", .colour = plot::cycle(1)});
    panel.curve(paired.t, paired.measured,
                {.label = "$h$ = 1.5 d$x$, with friction", .colour = plot::cycle(2)});
    panel.curve(damped.t, damped.predicted, plot::exact("linear theory, with friction"));
    panel.curve(paired.t, paired.predicted, plot::exact(""));
}

}  // namespace

void regularisation(report::Run& run) {
    constexpr double friction = 0.5;
    const std::vector<std::string> kernels =
        run.quick() ? std::vector<std::string>{"cubic"}
                    : std::vector<std::string>{"cubic", "quintic", "wendland-c2", "wendland-c4"};
    plot::Figure figure{"regularisation", 1, 2};
    const DisorderRun free = run_of(run, "cubic", 1.2, 0);
    DisorderRun damped, paired;
    plot::Panel& right = figure.at(0, 1)
                             .titled("with friction: mean rate of decay")
                             .labels("predicted / (10^{−3} $c$/d$x$)", "measured / (10^{−3} $c$/d$x$)");
    report::Table table{{"kernel", "h/dx", "fastest growth", "decay, measured", "predicted", "nearest pair"}};
    double worst = 0;
    for (const std::string& kernel : kernels) {
        plot::Values predicted, measured;
        for (const double h : {1.2, 1.5, 2.0}) {
            const DisorderRun one = run_of(run, kernel, h, friction);
            if (kernel == "cubic" && h == 1.2) damped = one;
            if (kernel == "cubic" && h == 1.5) paired = one;
            const double growth = fastest_wave<2>(named_lattice<2>(kernel, h), isotropic<2>(0.2)).rate;
            predicted.push_back(1e3 * one.predicted_rate());
            measured.push_back(1e3 * one.measured_rate());
            if (growth < 0.05) worst = std::max(worst, std::abs(measured.back() - predicted.back()));
            run.record(kernel + " h/dx = " + report::number(h, 2), 20,
                       {{"growth", growth, "c/dx"},
                        {"measured_rate", one.measured_rate(), "c/dx"},
                        {"predicted_rate", one.predicted_rate(), "c/dx"},
                        {"nearest", one.nearest, "dx"}});
            if (h == 1.5 && kernel != "cubic") continue;
            if (h == 2.0 && kernel == "wendland-c4") continue;
            table.row({kernel, report::fixed(h, 1), report::fixed(growth, 3),
                       report::fixed(one.measured_rate(), 3), report::fixed(one.predicted_rate(), 3),
                       report::fixed(one.nearest, 2)});
        }
        right.points(predicted, measured, look_of_kernel(kernel, kernel));
    }
    right.curve({-35, 35}, {-35, 35}, plot::exact("as predicted"));
    draw_histories(figure.at(0, 0), free, damped, paired);
    run.save(figure);
    run.record("cubic h/dx = 1.2 no friction", 20, {{"measured_rate", free.measured_rate(), "c/dx"}});
    run.fill("regularisation", table.markdown());
    run.claim("no-friction", [&] { return free.measured_rate() < 0.005; });
    run.claim("friction", [&] { return damped.measured_rate() > 0.02 && paired.measured_rate() < 0; });
    run.claim("as-predicted", [&] { return worst < 3; });
}

}  // namespace sph::tensile
