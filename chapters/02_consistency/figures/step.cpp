#include <map>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/jump_line.hpp"
#include "common/plot/looks.hpp"

namespace sph::consistency {
namespace {

void draw_exact(plot::Panel& value, plot::Panel& slope, const Function<1>& function) {
    for (const bool behind : {false, true}) {
        plot::Values x, A, dA_dx;
        for (const double s : linear_space(behind ? step_at : 0.38, behind ? 0.62 : step_at - 1e-9, 41)) {
            x.push_back(s);
            A.push_back(function.value({s}));
            dA_dx.push_back(function.gradient({s})[0]);
        }
        plot::Style exact = plot::exact(behind ? "" : "exact");
        exact.width = 1.2;
        value.curve(x, A, exact);
        slope.curve(x, dA_dx, exact);
    }
}

/// Open markers, so that those beneath are seen, but for the scheme that is exact here.
plot::Style jump_style(const JumpScheme& scheme) {
    plot::Style look = plot::look_of(scheme.name, scheme.label);
    look.filled = scheme.name == "dsph";
    return look;
}

/// One row of panels and two cells of each scheme's row: the step with the same slope on both sides, or with
/// a kink.
void draw_row(report::Run& run, plot::Figure& figure, bool kink, std::vector<std::vector<std::string>>& rows,
              std::map<std::string, JumpErrors>& finest) {
    const Function<1> function = step_function(kink);
    plot::Panel& left = figure.at(kink, 0).labels(kink ? "$x$" : "", "$A$").x_range(0.38, 0.62);
    plot::Panel& right = figure.at(kink, 1).labels(kink ? "$x$" : "", "d$A$/d$x$").x_range(0.38, 0.62);
    right.y_range(-6, 4);
    left.titled(kink ? "another slope behind the jump" : "the same slope on both sides");
    left.legend.shown = !kink;
    right.legend.shown = false;
    draw_exact(left, right, function);
    for (const std::size_t n : {std::size_t{100}, std::size_t{200}, std::size_t{400}, std::size_t{800}}) {
        const JumpLine line = line_with_jump(function, step_at, n, 0.2, run.seed(), run.threads());
        for (std::size_t k = 0; k < line.schemes.size(); ++k) {
            const JumpScheme& scheme = line.schemes[k];
            const JumpErrors errors = errors_near_jump(line, scheme, 0.1);
            run.record(scheme.name + (kink ? " kink" : ""), n,
                       {{"l2_f", errors.value}, {"l2_slope", errors.slope}});
            if (n == 100) {
                left.points(line.x, scheme.value, jump_style(scheme));
                right.points(line.x, scheme.slope, jump_style(scheme));
            } else if (n == 800) {
                if (!kink) rows[k].push_back(scheme.label);
                rows[k].push_back(report::number(errors.value, 2));
                rows[k].push_back(report::number(errors.slope, 2));
                finest[scheme.name + (kink ? " kink" : "")] = errors;
            }
        }
    }
}

}  // namespace

void step(report::Run& run) {
    plot::Figure figure{"step", 2, 2};
    figure.panel_height = 240;
    std::vector<std::vector<std::string>> rows(4);
    std::map<std::string, JumpErrors> finest;
    draw_row(run, figure, false, rows, finest);
    draw_row(run, figure, true, rows, finest);
    report::Table table{{"scheme", "equal slopes: A", "slope", "unequal slopes: A", "slope"}};
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("step", table.markdown());
    const auto needs = report::Needs::any_run;
    run.claim(
        "cspm-at-jump", [&] { return finest["cspm"].slope > 0.8 * finest["sph"].slope; }, needs);
    run.claim(
        "dsph-equal-slopes", [&] { return finest["dsph"].slope < 1e-3 && finest["dsph"].value < 2e-4; },
        needs);
    run.claim(
        "dsph-kink", [&] { return finest["dsph kink"].slope > 100 * finest["dsph"].slope; }, needs);
    run.claim(
        "one-side-enough",
        [&] {
            return finest["one-sided"].slope < 2 * finest["dsph"].slope &&
                   finest["one-sided kink"].slope < 1e-3;
        },
        needs);
}

}  // namespace sph::consistency
