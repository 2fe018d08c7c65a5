#include <numeric>

#include "chapters/02_consistency/discontinuity.hpp"
#include "chapters/02_consistency/figures/figures.hpp"

namespace sph::consistency {
namespace {

using K = QuinticSpline<1>;
using Estimates = InterpolationWithin<K, Free, Value, DifferenceGradient, Shepard, MatrixGradient<>,
                                      BeyondJump, DiscontinuousFit, OneSidedFit>;

struct Method {
    std::string name, label;
    Column value, slope;
};

struct Line {
    Column x, exact, exact_slope;
    std::vector<Method> methods;
};

Line interpolated(bool kink, std::size_t n, unsigned long seed, int threads) {
    constexpr double jitter = 0.2;
    const Function<1> function = sph::step(kink);
    const auto points = make_points<1>(Arrangement::jittered, n, jitter, seed);
    Estimates cloud{Free{}, points, 1.2 / static_cast<double>(n), function.value, true, threads};
    const auto& known = cloud.particles();
    const Jump jump = Jump::find(step_at, known.x[0], known.A);
    const auto& p = cloud.estimate(Effects{Value{}, DifferenceGradient{}, Shepard{}, MatrixGradient<>{},
                                           BeyondJump{jump}, DiscontinuousFit{jump}, OneSidedFit{}});
    Line line{p.x[0], p.A, {}, {}};
    for (const double x : line.x) line.exact_slope.push_back(function.gradient({x})[0]);
    line.methods = {{"sph", "SPH", p.value, p.gradient[0]},
                    {"cspm", "CSPM", p.shepard, p.matrix[0]},
                    {"dsph", "DSPH", p.dsph[0], p.dsph[1]},
                    {"one-sided", "one side", p.one_sided[0], p.one_sided[1]}};
    return line;
}

/// Relative L2 errors within two supports of the jump.
std::pair<double, double> errors_near_jump(const Line& line, const Method& method, double width) {
    double value = 0, slope = 0, size = 0, slope_size = 0;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (std::abs(line.x[i] - step_at) > width) continue;
        value += square(method.value[i] - line.exact[i]);
        slope += square(method.slope[i] - line.exact_slope[i]);
        size += square(line.exact[i]);
        slope_size += square(line.exact_slope[i]);
    }
    return {std::sqrt(value / size), std::sqrt(slope / slope_size)};
}

}  // namespace

namespace {

void draw_exact(plot::Panel& value, plot::Panel& slope, bool kink) {
    const Function<1> function = sph::step(kink);
    for (const bool behind : {false, true}) {
        plot::Values x, A, dA_dx;
        for (const double s : linear_space(behind ? step_at : 0.38, behind ? 0.62 : step_at - 1e-9, 41)) {
            x.push_back(s);
            A.push_back(function.value({s}));
            dA_dx.push_back(function.gradient({s})[0]);
        }
        const plot::Style exact{
            .label = behind ? "" : "exact", .colour = plot::Colour{0, 0, 0}, .width = 1.2};
        value.curve(x, A, exact);
        slope.curve(x, dA_dx, exact);
    }
}

plot::Style method_style(const std::string& label, std::size_t index) {
    constexpr std::array markers{plot::Marker::square, plot::Marker::circle, plot::Marker::diamond,
                                 plot::Marker::triangle_up};
    constexpr std::array colours{1, 0, 2, 3};
    return {.label = label,
            .colour = plot::cycle(static_cast<std::size_t>(colours.at(index))),
            .marker = markers.at(index),
            .marker_size = 5,
            .filled = index == 2};
}

}  // namespace

void step(report::Run& run) {
    plot::Figure figure{"step", 2, 2};
    figure.panel_height = 240;
    report::Table table{{"scheme", "equal slopes: A", "slope", "unequal slopes: A", "slope"}};
    std::vector<std::vector<std::string>> rows(4);
    for (const bool kink : {false, true}) {
        plot::Panel& left = figure.at(kink, 0).labels(kink ? "$x$" : "", "$A$").x_range(0.38, 0.62);
        plot::Panel& right =
            figure.at(kink, 1).labels(kink ? "$x$" : "", "d$A$/d$x$").x_range(0.38, 0.62).y_range(-6, 4);
        left.titled(kink ? "another slope behind the jump" : "the same slope on both sides");
        draw_exact(left, right, kink);
        for (const std::size_t n : {std::size_t{100}, std::size_t{200}, std::size_t{400}, std::size_t{800}}) {
            const Line line = interpolated(kink, n, run.seed(), run.threads());
            for (std::size_t m = 0; m < line.methods.size(); ++m) {
                const Method& method = line.methods[m];
                const std::string name = method.name + (kink ? " kink" : "");
                const auto [value, slope] = errors_near_jump(line, method, 0.1);
                run.result(name, static_cast<long>(n), "l2_f", value);
                run.result(name, static_cast<long>(n), "l2_slope", slope);
                if (n == 100) {
                    left.points(line.x, method.value, method_style(method.label, m));
                    right.points(line.x, method.slope, method_style(method.label, m));
                } else if (n == 800) {
                    if (!kink) rows[m].push_back(method.label);
                    rows[m].push_back(report::number(value, 2));
                    rows[m].push_back(report::number(slope, 2));
                }
            }
        }
        left.legend.shown = !kink;
        right.legend.shown = false;
    }
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("step", table.markdown());
}

}  // namespace sph::consistency
