#include "chapters/03_euler_sph/scenes/star.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::euler {
namespace {

void draw_exact(const exact::ToyStar& star, plot::Panel& radius, plot::Panel& density) {
    const double end = 5 * star.period();
    plot::draw_exact(radius, 0, end, [&](double t) { return star.at(t).radius; });
    const auto last = star.at(end);
    plot::draw_exact(density, -last.radius, last.radius, [&](double x) { return last.density(x); });
}

/// Every fifth radius, and the densities at the end.
void draw(const NonlinearRun& star, plot::Panel& radius, plot::Panel& density) {
    plot::Values few_t, few;
    for (std::size_t k = 0; k < star.t.size(); k += 5) {
        few_t.push_back(star.t[k]);
        few.push_back(star.radius[k]);
    }
    plot::Style look{.label = "SPH", .colour = plot::cycle(1), .marker = plot::Marker::circle};
    look.marker_size = 3.5;
    radius.points(few_t, few, look);
    look.marker_size = 3;
    density.points(star.x, star.rho, look);
}

}  // namespace

void star_nonlinear(report::Run& run) {
    plot::Figure figure{"star-nonlinear", 2, 2};
    report::Comparison table{{"γ", "h", "kernel"},
                             {{"radius", "radius_error", report::digits(2)},
                              {"v at the end", "l1_v", report::digits(2)},
                              {"energy drift", "energy_drift", report::digits(1)}}};
    int row = 0;
    for (const double gamma : {2.0, 1.4}) {
        StarScene scene;
        scene.n = run.quick() ? 100 : gamma == 2 ? 400 : 200;
        scene.gamma = gamma;
        scene.threads = run.threads();
        const double A_0 = 1;
        const exact::ToyStar exact = scene.exact(A_0);
        plot::Panel& left =
            figure.at(row, 0).titled("γ = " + report::number(gamma, 2)).labels("Ω$t$", "radius");
        plot::Panel& right = figure.at(row, 1).titled("after five periods").labels("$x$", "ρ");
        draw_exact(exact, left, right);
        // The super-Gaussian, which is negative in places, finds no star at rest for gamma = 1.4.
        std::vector<GasMethod> methods{{"without-omega", "cubic", 1.2}, {"consistent-h", "cubic", 1.2}};
        if (gamma == 2) methods.push_back({"consistent-h", "super-gaussian", 1.2});
        for (const GasMethod& method : methods) {
            const NonlinearRun star = run_nonlinear(scene, method, A_0, 5 * exact.period(), 0.6);
            const std::string name =
                method.resolution + " " + method.kernel + " gamma=" + report::number(gamma, 2);
            const bool with_omega = method.resolution == "consistent-h";
            table.add(run, name, scene.n,
                      {report::number(gamma, 2), with_omega ? "with Ω" : "without Ω", method.kernel},
                      star.measured());
            if (!with_omega || method.kernel != "cubic") continue;
            draw(star, left, right);
            if (gamma != 2) continue;
            // One pass of each evaluation is the force's.
            const double passes =
                static_cast<double>(star.counters.passes) / static_cast<double>(star.counters.steps) - 1;
            run.record(name, scene.n, {{"density_passes_per_step", passes}});
            run.fill("passes", report::number(passes, 1));
        }
        right.legend.shown = false;
        ++row;
    }
    run.save(figure);
    run.fill("star-nonlinear", table.markdown());
}

}  // namespace sph::euler
