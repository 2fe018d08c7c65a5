#include <algorithm>
#include <map>

#include "chapters/03_euler_sph/scenes/star.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"

/// A toy star that swings to half and to 1.7 times its radius: errors of radius and energy over time.
namespace sph::euler {
namespace {

/// The methods by their names in the register of looks.
std::vector<GasMethod> methods_for(double gamma) {
    std::vector<GasMethod> methods{{"without-omega", "cubic", 1.2, "without-omega", "without $Ω_{h}$"},
                                   {"consistent-h", "cubic", 1.2, "consistent-h", "with $Ω_{h}$"}};
    // The super-Gaussian, which is negative in places, finds no star at rest for gamma = 1.4.
    if (gamma == 2)
        methods.push_back(
            {"consistent-h", "super-gaussian", 1.2, "super-gaussian", "with $Ω_{h}$, super-Gaussian"});
    return methods;
}

struct Panels {
    plot::Panel &radius, &error, &energy;
};

void draw(const Panels& panels, const GasMethod& method, const NonlinearRun& star) {
    const plot::Style look = plot::look_of(method.name, method.label);
    plot::Values t, error, energy, few_t, few;
    for (std::size_t k = 0; k < star.t.size(); k += 2) {
        t.push_back(star.t[k]);
        error.push_back(std::max(1e-7, std::abs(star.radius[k] / star.exact_radius[k] - 1)));
        energy.push_back(std::max(1e-9, std::abs(star.energy[k])));
        if (k % 8 != 0) continue;
        few_t.push_back(star.t[k]);
        few.push_back(star.radius[k]);
    }
    panels.error.curve(t, error, plot::line(look));
    panels.energy.curve(t, energy, plot::line(look));
    if (method.name == "consistent-h") panels.radius.points(few_t, few, plot::dots(look, 4));
}

using Runs = std::map<std::string, NonlinearRun>;  // of gamma = 2

void claims(report::Run& run, const Runs& runs) {
    const NonlinearRun &with = runs.at("consistent-h"), &without = runs.at("without-omega"),
                       &super = runs.at("super-gaussian");
    run.claim("omega-keeps-the-star", [&] {
        return with.radius_error < without.radius_error / 10 && with.energy_drift < 2e-6 &&
               without.energy_drift > 0.005;
    });
    run.claim("super-gaussian-star", [&] {
        return super.radius_error < with.radius_error / 20 &&
               std::abs(super.velocity_error / with.velocity_error - 1) < 0.1;
    });
    // One pass of each evaluation is the force's.
    const double passes =
        static_cast<double>(with.counters.passes) / static_cast<double>(with.counters.steps) - 1;
    run.record("consistent-h cubic gamma=2.0", with.x.size(), {{"density_passes_per_step", passes}});
    run.fill("passes", report::number(passes, 1));
}

}  // namespace

void star_nonlinear(report::Run& run) {
    plot::Figure figure{"star-nonlinear", 1, 3};
    figure.panel_width = 270;
    const Panels panels{figure.at(0, 0).titled("radius").labels("Ω$t$", "radius"),
                        figure.at(0, 1).log_y().titled("its error").labels("Ω$t$", "relative error"),
                        figure.at(0, 2).log_y().titled("energy").labels("Ω$t$", "| Δ$E$ / $E$ |")};
    panels.error.y_range(1e-7, 0.1);
    panels.energy.y_range(1e-9, 0.1);
    report::Comparison table{{"γ", "h", "kernel"},
                             {{"radius", "radius_error", report::digits(2)},
                              {"v at the end", "l1_v", report::digits(2)},
                              {"energy", "energy_drift", report::digits(1)}}};
    Runs runs;
    for (const double gamma : {2.0, 1.4}) {
        StarScene scene;
        scene.n = run.quick() ? 100 : gamma == 2 ? 400 : 200;
        scene.gamma = gamma;
        scene.threads = run.threads();
        const double A_0 = 1;
        const exact::ToyStar exact = scene.exact(A_0);
        const double end = 5 * exact.period();
        if (gamma == 2) plot::draw_exact(panels.radius, 0, end, [&](double t) { return exact.at(t).radius; });
        for (const GasMethod& method : methods_for(gamma)) {
            const NonlinearRun star = run_nonlinear(scene, method, A_0, end, 0.6);
            const std::string name =
                method.resolution + " " + method.kernel + " gamma=" + report::number(gamma, 2);
            const bool with_omega = method.resolution == "consistent-h";
            table.add(
                run, name, scene.n,
                {report::number(gamma, 2), with_omega ? "with $Ω_{h}$" : "without $Ω_{h}$", method.kernel},
                star.measured());
            if (gamma != 2) continue;
            draw(panels, method, star);
            runs[method.name] = star;
        }
    }
    panels.radius.legend.shown = false;
    panels.energy.legend.shown = false;
    run.save(figure);
    run.fill("star-nonlinear", table.markdown());
    claims(run, runs);
}

}  // namespace sph::euler
