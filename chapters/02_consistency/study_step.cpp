#include <numeric>

#include "chapters/02_consistency/discontinuity.hpp"
#include "chapters/02_consistency/studies.hpp"

namespace sph::consistency {
namespace {

using K = QuinticSpline<1>;
using Estimates = InterpolationWithin<K, Free, Value, DifferenceGradient, Shepard, MatrixGradient<>,
                                      BeyondJump, DiscontinuousFit>;

struct Method {
    std::string name, label;
    Column value, slope;
};

struct Line {
    Column x, exact, exact_slope;
    std::vector<Method> methods;
};

Line interpolated(std::size_t n, double jitter, unsigned long seed, int threads) {
    const Function<1> function = sph::step();
    const auto points =
        make_points<1>(jitter > 0 ? Arrangement::jittered : Arrangement::even, n, jitter, seed);
    Estimates cloud{Free{}, points, 1.2 / static_cast<double>(n), function.value, true, threads};
    const auto& known = cloud.particles();
    const Jump jump = Jump::find(step_at, known.x[0], known.A);
    const auto& p = cloud.estimate(Effects{Value{}, DifferenceGradient{}, Shepard{}, MatrixGradient<>{},
                                           BeyondJump{jump}, DiscontinuousFit{jump}});
    Line line{p.x[0], p.A, {}, {}};
    for (const double x : line.x) line.exact_slope.push_back(function.gradient({x})[0]);
    line.methods = {{"sph", "SPH", p.value, p.gradient[0]},
                    {"cspm", "CSPM", p.shepard, p.matrix[0]},
                    {"dsph", "DSPH", p.dsph[0], p.dsph[1]}};
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

void step(report::Run& run) {
    plot::Figure figure{"step", 1, 2};
    plot::Panel& left = figure.at(0, 0).labels("$x$", "$A$").x_range(0.38, 0.62);
    plot::Panel& right = figure.at(0, 1).labels("$x$", "d$A$/d$x$").x_range(0.38, 0.62).y_range(-36, 4);
    const Function<1> function = sph::step();
    for (const bool behind : {false, true}) {
        plot::Values x, value, slope;
        for (const double s : linear_space(behind ? step_at : 0.38, behind ? 0.62 : step_at - 1e-9, 41)) {
            x.push_back(s);
            value.push_back(function.value({s}));
            slope.push_back(function.gradient({s})[0]);
        }
        const plot::Style exact{
            .label = behind ? "" : "exact", .colour = plot::Colour{0, 0, 0}, .width = 1.2};
        left.curve(x, value, exact);
        right.curve(x, slope, exact);
    }
    const std::vector<std::size_t> sizes{100, 200, 400, 800};
    report::Table table{
        {"scheme", "A: 100 particles", "800 particles", "slope: 100 particles", "800 particles"}};
    std::vector<std::vector<std::string>> rows(3);
    for (const std::size_t n : sizes) {
        const Line line = interpolated(n, 0.2, run.seed(), run.threads());
        for (std::size_t m = 0; m < line.methods.size(); ++m) {
            const Method& method = line.methods[m];
            const auto [value, slope] = errors_near_jump(line, method, 0.1);
            run.result(method.name, static_cast<long>(n), "l2_f", value);
            run.result(method.name, static_cast<long>(n), "l2_slope", slope);
            if (n == sizes.front())
                rows[m] = {method.label, report::number(value, 2), "", report::number(slope, 2), ""};
            if (n == sizes.back()) {
                rows[m][2] = report::number(value, 2);
                rows[m][4] = report::number(slope, 2);
            }
            if (n != sizes.front()) continue;
            constexpr std::array markers{plot::Marker::square, plot::Marker::circle, plot::Marker::diamond};
            const plot::Style dots{.label = method.label,
                                   .colour = plot::cycle(m == 2 ? 2 : 1 - m),
                                   .marker = markers.at(m),
                                   .marker_size = 5,
                                   .filled = m == 2};
            left.points(line.x, method.value, dots);
            right.points(line.x, method.slope, dots);
        }
    }
    right.legend.shown = false;
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("step", table.markdown());
}

}  // namespace sph::consistency
