#include "chapters/03_euler_sph/scenes/star.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"
#include "common/exact/toy_star.hpp"
#include "common/exact/toy_star_modes.hpp"

namespace sph::euler {
namespace {

struct StarLine {
    std::string name, label;
    GasScheme scheme;
    Spacing spacing;
    plot::Marker marker;
};
std::vector<StarLine> star_lines() {
    using plot::Marker;
    return {
        {"equal masses", "equal masses", {"consistent-h", "cubic", 1.2}, Spacing::masses, Marker::square},
        {"even spacing", "even spacing", {"consistent-h", "cubic", 1.2}, Spacing::even, Marker::triangle_up},
        {"graded", "graded spacing", {"consistent-h", "cubic", 1.2}, Spacing::graded, Marker::circle},
        {"graded without-omega",
         "graded, without Ω",
         {"without-omega", "cubic", 1.2},
         Spacing::graded,
         Marker::diamond},
        {"graded super-gaussian",
         "graded, super-Gaussian",
         {"consistent-h", "super-gaussian", 1.2},
         Spacing::graded,
         Marker::triangle_down}};
}

}  // namespace

void star_modes(report::Run& run) {
    plot::Figure figure{"star-modes", 1, 2};
    plot::Panel& left = figure.at(0, 0).titled("mode 3 after 5 periods").labels("$x$", "$v$ / amplitude");
    plot::Panel& right =
        figure.at(0, 1).log_y().titled("frequencies, γ = 2").labels("mode", "| ω / ω_{exact} − 1 |");
    StarScene scene;
    scene.n = run.quick() ? 100 : 400;
    scene.threads = run.threads();
    const auto n = static_cast<long>(scene.n);
    report::Table table{{"particles", "mode 3", "mode 5", "mode 10", "mode 20"}};
    std::size_t index = 0;
    for (const StarLine& line : star_lines()) {
        scene.spacing = line.spacing;
        const auto omega = star_frequencies(scene, line.scheme, 20);
        plot::Values mode, error;
        std::vector<std::string> row{line.label};
        for (int k = 1; k <= 20; ++k) {
            const double relative =
                omega[static_cast<std::size_t>(k - 1)] / exact::toy_star_frequency(2, k) - 1;
            run.result(line.name + " mode=" + std::to_string(k), n, "omega_error", relative);
            if (k == 3 || k == 5 || k == 10 || k == 20) row.push_back(report::number(relative, 1));
            if (k < 3) continue;  // exact; what is left is the Jacobian's rounding
            mode.push_back(k);
            error.push_back(std::abs(relative));
        }
        table.row(row);
        right.curve(mode, error,
                    {.label = line.label, .colour = plot::cycle(index++), .marker = line.marker});
    }
    scene.spacing = Spacing::even;
    Column Omega = star_omega(scene, star_lines()[1].scheme);
    std::sort(Omega.begin(), Omega.end());
    const double low = Omega[Omega.size() / 20], high = Omega[Omega.size() - 1 - Omega.size() / 20];
    run.result("even spacing", n, "omega_5_percent", low);
    run.result("even spacing", n, "omega_95_percent", high);
    run.fill("omega-low", report::fixed(low, 3));
    run.fill("omega-high", report::fixed(high, 3));
    // The same in time, for the scheme that is best: modes 1 and 2 are exact, whatever N is.
    scene.spacing = Spacing::graded;
    const std::vector<StarLine> lines = star_lines();
    double worst = 0;
    for (const int k : {1, 2}) {
        const StarRun oscillation = run_mode(scene, lines[2].scheme, k, 1, 0.01);
        const double relative = oscillation.omega / exact::toy_star_frequency(2, k) - 1;
        worst = std::max(worst, std::abs(relative));
        run.result("graded in time mode=" + std::to_string(k), n, "omega_error", relative);
    }
    run.fill("star-exact", worst < 1e-8 ? "10⁻⁸" : report::number(worst, 1));
    const StarRun twenty = run_mode(scene, lines[4].scheme, 20, 4);
    const double relative = twenty.omega / exact::toy_star_frequency(2, 20) - 1;
    run.result("graded super-gaussian in time mode=20", n, "omega_error", relative);
    run.fill("star-twenty", report::number(relative, 1));
    const StarRun three = run_mode(scene, lines[2].scheme, 3, 4);
    plot::Values x, v;
    const double end = three.exact_v.back() / exact::toy_star_velocity(2, 3, std::min(1.0, three.x.back()));
    for (int k = 0; k <= 200; ++k) {
        x.push_back(-1 + k / 100.0);
        v.push_back(end * exact::toy_star_velocity(2, 3, x.back()));
    }
    left.curve(x, v, exact_line());
    left.points(
        three.x, three.v,
        {.label = "graded", .colour = plot::cycle(2), .marker = plot::Marker::circle, .marker_size = 3});
    right.legend.outside = true;
    run.save(figure);
    run.fill("star-modes", table.markdown());
}

void star_nonlinear(report::Run& run) {
    plot::Figure figure{"star-nonlinear", 2, 2};
    report::Table table{{"γ", "h", "kernel", "radius", "v at the end", "energy drift"}};
    int row = 0;
    for (const double gamma : {2.0, 1.4}) {
        StarScene scene;
        scene.n = run.quick() ? 100 : gamma == 2 ? 400 : 200;
        scene.gamma = gamma;
        scene.threads = run.threads();
        const double A_0 = 1;
        const exact::ToyStar star{gamma, scene.state().K, 1, A_0, 1, 1};
        plot::Panel& left =
            figure.at(row, 0).titled("γ = " + report::number(gamma, 2)).labels("Ω$t$", "radius");
        plot::Panel& right = figure.at(row, 1).titled("after five periods").labels("$x$", "ρ");
        plot::Values t, radius;
        for (int k = 0; k <= 500; ++k) {
            t.push_back(5 * star.period() * k / 500);
            radius.push_back(star.at(t.back()).radius);
        }
        left.curve(t, radius, exact_line());
        plot::Values x, rho;
        const auto end = star.at(5 * star.period());
        for (int k = 0; k <= 200; ++k) {
            x.push_back(end.radius * (-1 + k / 100.0));
            rho.push_back(end.density(x.back()));
        }
        right.curve(x, rho, exact_line());
        // The super-Gaussian, which is negative in places, finds no star at rest for gamma = 1.4.
        std::vector<GasScheme> schemes{{"without-omega", "cubic", 1.2}, {"consistent-h", "cubic", 1.2}};
        if (gamma == 2) schemes.push_back({"consistent-h", "super-gaussian", 1.2});
        std::size_t index = 0;
        for (const GasScheme& scheme : schemes) {
            const NonlinearRun star_run = run_nonlinear(scene, scheme, A_0, 5 * star.period(), 0.6);
            const std::string method =
                scheme.resolution + " " + scheme.kernel + " gamma=" + report::number(gamma, 2);
            const auto n = static_cast<long>(scene.n);
            run.result(method, n, "radius_error", star_run.radius_error);
            run.result(method, n, "l1_v", star_run.velocity_error);
            run.result(method, n, "energy_drift", star_run.energy_drift);
            run.result(method, n, "momentum_drift", star_run.momentum);
            run.result(method, n, "steps", static_cast<double>(star_run.counters.steps));
            run.result(method, n, "pairs", static_cast<double>(star_run.counters.pairs));
            table.row({report::number(gamma, 2), scheme.resolution == "consistent-h" ? "with Ω" : "without Ω",
                       scheme.kernel, report::number(star_run.radius_error, 2),
                       report::number(star_run.velocity_error, 2), report::number(star_run.energy_drift, 1)});
            if (gamma == 2 && scheme.kernel == "cubic" && scheme.resolution == "consistent-h") {
                // One pass of each evaluation is the force's.
                const double passes = static_cast<double>(star_run.counters.passes) /
                                          static_cast<double>(star_run.counters.steps) -
                                      1;
                run.result(method, n, "density_passes_per_step", passes);
                run.fill("passes", report::number(passes, 1));
            }
            if (scheme.kernel == "cubic" && scheme.resolution == "consistent-h") {
                plot::Values few_t, few;
                for (std::size_t k = 0; k < star_run.t.size(); k += 5) {
                    few_t.push_back(star_run.t[k]);
                    few.push_back(star_run.radius[k]);
                }
                left.points(few_t, few,
                            {.label = "SPH",
                             .colour = plot::cycle(index),
                             .marker = plot::Marker::circle,
                             .marker_size = 3.5});
                right.points(star_run.x, star_run.rho,
                             {.label = "SPH",
                              .colour = plot::cycle(index),
                              .marker = plot::Marker::circle,
                              .marker_size = 3});
            }
            ++index;
        }
        right.legend.shown = false;
        ++row;
    }
    run.save(figure);
    run.fill("star-nonlinear", table.markdown());
}

}  // namespace sph::euler
