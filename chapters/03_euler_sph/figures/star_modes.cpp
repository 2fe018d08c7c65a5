#include <algorithm>
#include <map>

#include "chapters/03_euler_sph/scenes/star.hpp"
#include "common/exact/toy_star_modes.hpp"
#include "common/plot/looks.hpp"

namespace sph::euler {
namespace {

struct Line {
    std::string name, label;
    GasMethod method;
    Spacing spacing;
    plot::Marker marker;
};
std::vector<Line> all_lines() {
    using plot::Marker;
    const GasMethod cubic{"consistent-h", "cubic", 1.2};
    return {{"equal masses", "equal masses", cubic, Spacing::masses, Marker::square},
            {"even spacing", "even spacing", cubic, Spacing::even, Marker::triangle_up},
            {"graded", "graded spacing", cubic, Spacing::graded, Marker::circle},
            {"graded without-omega",
             "graded, without $Ω_{h}$",
             {"without-omega", "cubic", 1.2},
             Spacing::graded,
             Marker::diamond},
            {"graded super-gaussian",
             "graded, super-Gaussian",
             {"consistent-h", "super-gaussian", 1.2},
             Spacing::graded,
             Marker::triangle_down}};
}

/// Errors of twenty frequencies by each way to space the particles: curves, rows, a table.
void frequencies(report::Run& run, StarScene scene, plot::Panel& panel) {
    report::Table table{{"particles", "mode 3", "mode 5", "mode 10", "mode 20"}};
    std::map<std::string, plot::Values> errors;  // of modes 3 to 20
    std::size_t index = 0;
    for (const Line& line : all_lines()) {
        scene.spacing = line.spacing;
        const auto omega = star_frequencies(scene, line.method, 20);
        plot::Values mode, error;
        std::vector<std::string> row{line.label};
        for (int k = 1; k <= 20; ++k) {
            const double relative =
                omega[static_cast<std::size_t>(k - 1)] / exact::toy_star_frequency(2, k) - 1;
            run.record(line.name + " mode=" + std::to_string(k), scene.n, {{"omega_error", relative}});
            if (k == 3 || k == 5 || k == 10 || k == 20) row.push_back(report::number(relative, 1));
            if (k < 3) continue;  // exact; what is left is the Jacobian's rounding
            mode.push_back(k);
            error.push_back(std::abs(relative));
        }
        table.row(row);
        errors[line.name] = error;
        panel.curve(mode, error,
                    {.label = line.label, .colour = plot::cycle(index++), .marker = line.marker});
    }
    run.fill("star-modes", table.markdown());
    run.claim("modes-want-fine-edges", [&] {
        return errors["graded"][17] < errors["equal masses"][17] / 5 &&
               errors["graded super-gaussian"][17] < errors["graded"][17] / 50;
    });
    run.claim("without-omega-is-lucky",
              [&] { return std::abs(errors["graded without-omega"][17]) < errors["graded"][17] / 100; });
}

/// How little Omega varies over the star.
void range_of_omega(report::Run& run, StarScene scene) {
    scene.spacing = Spacing::even;
    Column Omega = star_omega(scene, all_lines()[1].method);
    std::sort(Omega.begin(), Omega.end());
    const double low = Omega[Omega.size() / 20], high = Omega[Omega.size() - 1 - Omega.size() / 20];
    run.record("even spacing", scene.n, {{"omega_5_percent", low}, {"omega_95_percent", high}});
    run.fill("omega-low", report::fixed(low, 3));
    run.fill("omega-high", report::fixed(high, 3));
    run.claim("omega-nearly-constant", [&] { return high - low < 1e-3; });
}

/// The same in time, for the method that is best: modes 1 and 2 are exact, whatever N is.
void modes_in_time(report::Run& run, const StarScene& scene) {
    const std::vector<Line> lines = all_lines();
    const auto error = [&](const Line& line, int mode, int periods, double phase_step) {
        const StarRun oscillation = run_mode(scene, line.method, mode, periods, phase_step);
        const double relative = oscillation.omega / exact::toy_star_frequency(2, mode) - 1;
        run.record(line.name + " in time mode=" + std::to_string(mode), scene.n, {{"omega_error", relative}});
        return relative;
    };
    double worst = 0;
    for (const int mode : {1, 2}) worst = std::max(worst, std::abs(error(lines[2], mode, 1, 0.01)));
    run.fill("star-exact", worst < 1e-8 ? "10⁻⁸" : report::number(worst, 1));
    const double twenty = error(lines[4], 20, 4, 0.1);
    run.fill("star-twenty", report::number(twenty, 1));
    run.claim("first-modes-exact", [&] { return worst < 1e-8; });
    run.claim("mode-twenty", [&] { return std::abs(twenty) < 1e-4; });
}

void draw_mode_three(const StarScene& scene, plot::Panel& panel) {
    const StarRun three = run_mode(scene, all_lines()[2].method, 3, 4);
    const double end = three.exact_v.back() / exact::toy_star_velocity(2, 3, std::min(1.0, three.x.back()));
    plot::draw_exact(panel, -1, 1, [&](double x) { return end * exact::toy_star_velocity(2, 3, x); });
    plot::Values x, v;  // every tenth
    for (std::size_t i = 0; i < three.x.size(); i += 10) {
        x.push_back(three.x[i]);
        v.push_back(three.v[i]);
    }
    panel.points(
        x, v,
        {.label = "graded", .colour = plot::cycle(2), .marker = plot::Marker::circle, .marker_size = 5});
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
    frequencies(run, scene, right);
    range_of_omega(run, scene);
    modes_in_time(run, scene);
    draw_mode_three(scene, left);
    right.legend.outside = true;
    run.save(figure);
}

}  // namespace sph::euler
