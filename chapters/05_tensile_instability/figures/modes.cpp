#include "chapters/05_tensile_instability/scenes/modes.hpp"
#include "chapters/05_tensile_instability/figures/kernel_looks.hpp"

#include "common/report/chapter.hpp"

namespace sph::tensile {
namespace {

struct Case {
    std::string kernel;
    double h_over_dx;
};

/// The smaller omega^2 of waves along x, as a line.
void draw_prediction(plot::Panel& panel, const Case& one, double P, const plot::Style& look) {
    const auto lattice = named_lattice<2>(one.kernel, one.h_over_dx);
    plot::Values k, omega2;
    for (int n = 1; n <= 100; ++n) {
        k.push_back(n / 100.0);
        const auto M = dispersion_matrix<2>(lattice, isotropic<2>(P), {pi * k.back(), 0});
        omega2.push_back(squared_frequencies<2>(M)[0].real());
    }
    panel.curve(k, omega2, plot::line(look));
}

}  // namespace

void modes(report::Run& run) {
    const std::vector<Case> cases{{"cubic", 1.2}, {"quintic", 1.5}, {"wendland-c2", 1.5}};
    const std::vector<std::array<int, 2>> off_axis{{8, 3}, {10, 10}, {4, 4}, {6, 2}};
    plot::Figure figure{"modes", 1, 2};
    double worst = 0;
    int growing = 0, all = 0;
    for (const double P : {-0.3, 0.3}) {
        plot::Panel& panel = figure.at(0, P < 0 ? 0 : 1)
                                 .titled(P < 0 ? "tension, $P$ = −0.3" : "pressure, $P$ = 0.3")
                                 .labels("$k_{x}$ d$x$ / π", "ω^{2} d$x$^{2} / $c$^{2}");
        for (const Case& one : cases) {
            plot::Style look = look_of_kernel(
                one.kernel, one.kernel + ", $h$ = " + report::fixed(one.h_over_dx, 1) + " d$x$");
            draw_prediction(panel, one, P, look);
            plot::Values k, measured;
            std::vector<std::array<int, 2>> waves{{5, 0}, {6, 0}, {7, 0}, {8, 0}, {10, 0}};
            waves.insert(waves.end(), off_axis.begin(), off_axis.end());
            if (run.quick()) waves = {{5, 0}, {10, 0}, {8, 3}};
            for (const auto& wave : waves) {
                LatticeBox box{.kernel = one.kernel, .h_over_dx = one.h_over_dx, .pressure = P};
                box.wave.waves = wave;
                box.threads = run.threads();
                const ModeRun mode = run_mode(box);
                worst = std::max(worst, mode.rate_error());
                growing += mode.measured < 0 ? 1 : 0;
                ++all;
                run.record(one.kernel + " P = " + report::number(P, 1) + " waves " + std::to_string(wave[0]) +
                               " " + std::to_string(wave[1]),
                           box.per_side,
                           {{"omega2", mode.measured, "c^2/dx^2"},
                            {"predicted_omega2", mode.predicted, "c^2/dx^2"}});
                if (wave[1] != 0) continue;
                k.push_back(wave[0] / 10.0);
                measured.push_back(mode.measured);
            }
            look.label = "";
            panel.points(k, measured, plot::dots(look, 5));
        }
    }
    figure.at(0, 1).legend.shown = false;
    run.save(figure);
    run.fill("modes-growing", std::to_string(growing));
    run.fill("modes-all", std::to_string(all));
    run.claim(
        "modes", [&] { return worst < 1e-6; }, report::Needs::any_run);
}

}  // namespace sph::tensile
