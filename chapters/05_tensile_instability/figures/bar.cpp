#include "chapters/05_tensile_instability/scenes/bar.hpp"

#include <algorithm>

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/chapter.hpp"

namespace sph::tensile {
namespace {

double largest(const Column& u) {
    double most = 0;
    for (const double one : u) most = std::max(most, std::abs(one));
    return most;
}

/// The mean over the later half of the run.
double settled(const Column& u) {
    double sum = 0;
    for (std::size_t k = u.size() / 2; k < u.size(); ++k) sum += u[k];
    return sum / static_cast<double>(u.size() - u.size() / 2);
}

}  // namespace

void bar(report::Run& run) {
    Bar scene{.time = run.quick() ? 15.0 : 40.0};
    scene.threads = run.threads();
    plot::Figure figure{"bar", 1, 2};
    std::vector<BarRun> runs;
    for (const double P : {-0.2, 0.2}) {
        plot::Panel& panel = figure.at(0, P < 0 ? 0 : 1)
                                 .titled(P < 0 ? "tension, $P$ = −0.2" : "pressure, $P$ = 0.2")
                                 .labels("$t c$ / d$x$", "$u$ of the struck particle / (10^{−3} d$x$)");
        for (const BarScheme scheme : {BarScheme::sph, BarScheme::cspm}) {
            const bool is_sph = scheme == BarScheme::sph;
            scene.scheme = scheme, scene.pressure = P;
            const BarRun& one = runs.emplace_back(run_bar(scene));
            plot::Values u = one.u;
            for (double& value : u) value *= 1e3;
            panel.curve(one.t, u,
                        plot::line(plot::look_of(is_sph ? "sph" : "cspm", is_sph ? "SPH" : "CSPM")));
            run.record(std::string{is_sph ? "sph" : "cspm"} + " P = " + report::number(P, 1),
                       static_cast<std::size_t>(scene.particles),
                       {{"l1_u", one.error()},
                        {"largest_u", largest(one.u), "dx"},
                        {"settled_u", settled(one.u), "dx"},
                        {"lost", one.lost.value_or(0), "dx/c"}});
        }
        plot::Values exact = runs.back().exact;
        for (double& value : exact) value *= 1e3;
        panel.curve(runs.back().t, exact, plot::exact());
        panel.y_range(-1, 3);
    }
    run.save(figure);
    const BarRun &pulled = runs[0], &corrected = runs[1], &pressed = runs[2];
    run.fill("bar-lost", report::fixed(pulled.lost.value_or(0), 0));
    // Where omega vanishes with the slope c', a struck lattice is left displaced by V dx/(2 c'): at k = 0 by
    // sound, c' = 1; and for CSPM at k = pi/dx, too.
    constexpr double slope_at_pi = 0.698, expected = (1 + 1 / slope_at_pi) / 2;
    run.claim(
        "bar-lost", [&] { return pulled.lost && *pulled.lost < 15 && !corrected.lost && !pressed.lost; },
        report::Needs::any_run);
    run.fill("bar-cspm", report::fixed(1e3 * settled(corrected.u), 1));
    run.fill("bar-exact", report::fixed(1e3 * settled(corrected.exact), 1));
    run.claim("bar-cspm", [&] {
        return std::abs(settled(corrected.u) / scene.push - expected) < 0.05 &&
               std::abs(settled(corrected.exact) / scene.push - 0.5) < 0.02;
    });
    run.claim("bar-error", [&] { return corrected.error() > 1 && pressed.error() > 1.0 / 3; });
}

}  // namespace sph::tensile
