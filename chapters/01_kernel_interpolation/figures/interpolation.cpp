#include <algorithm>
#include <array>
#include <numeric>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/options.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/plot/looks.hpp"

namespace sph::interpolation {
namespace {

/// The estimates as curves, from left to right.
struct Profile {
    plot::Values x, value, plain, gradient, weighted, twice, laplacian;
    explicit Profile(const Estimates<1>& e) {
        std::vector<std::size_t> order(e.x.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t i, std::size_t j) { return e.x[i][0] < e.x[j][0]; });
        for (const std::size_t i : order) {
            x.push_back(e.x[i][0]);
            value.push_back(e.value[i]);
            plain.push_back(e.plain[i][0]);
            gradient.push_back(e.gradient[i][0]);
            weighted.push_back(e.weighted[i][0]);
            twice.push_back(e.twice[i]);
            laplacian.push_back(e.laplacian[i]);
        }
    }
};

void draw_exact(plot::Panel& left, plot::Panel& middle, plot::Panel& right) {
    const plot::Values x = linear_space(0, 1, 401);
    plot::Values value, slope, curvature;
    for (const double position : x) {
        value.push_back(TestFunction<1>::value({position}));
        slope.push_back(TestFunction<1>::gradient({position})[0]);
        curvature.push_back(TestFunction<1>::laplacian({position}));
    }
    plot::Style exact = plot::exact();
    exact.width = 1.2;
    left.curve(x, value, exact);
    middle.curve(x, slope, exact);
    right.curve(x, curvature, exact);
}

void draw_row(plot::Figure& figure, int row, const Profile& e) {
    using plot::Marker;
    const auto dots = [](std::string label, std::size_t colour, Marker marker, bool filled = true) {
        return plot::Style{.label = std::move(label),
                           .colour = plot::cycle(colour),
                           .marker = marker,
                           .marker_size = 4.5,
                           .filled = filled,
                           .layer = 2};
    };
    plot::Panel& left = figure.at(row, 0).labels("$x$", "$A$").x_range(0, 1);
    plot::Panel& middle = figure.at(row, 1).labels("$x$", "d$A$/d$x$").x_range(0, 1).y_range(-14, 14);
    plot::Panel& right = figure.at(row, 2).labels("$x$", "d^{2}$A$/d$x$^{2}").x_range(0, 1);
    right.y_range(-300, 200);
    draw_exact(left, middle, right);
    left.points(e.x, e.value, dots("(1.3)", 0, Marker::circle));
    middle.points(e.x, e.plain, dots("(1.11)", 1, Marker::square, false));
    middle.points(e.x, e.gradient, dots("(1.12)", 0, Marker::circle));
    middle.points(e.x, e.weighted, dots("(1.13)", 2, Marker::triangle_up, false));
    right.points(e.x, e.twice, dots("(1.15)", 1, Marker::square, false));
    right.points(e.x, e.laplacian, dots("Brookshaw (1.16)", 0, Marker::circle));
}

/// An estimate as tables and results name it.
struct Line {
    std::string name, equation, quantity;
    double Errors::*error;
};
const std::array<Line, 6>& lines() {
    static const std::array<Line, 6> all{
        {{"A", "(1.3)", "l2_value", &Errors::value},
         {"dA/dx", "(1.11)", "l2_slope_plain", &Errors::plain},
         {"dA/dx, differences", "(1.12)", "l2_slope", &Errors::gradient},
         {"dA/dx, weighed by mass", "(1.13)", "l2_slope_weighted", &Errors::weighted},
         {"d²A/dx², twice differentiated", "(1.15)", "l2_curvature_twice", &Errors::twice},
         {"d²A/dx², Brookshaw", "(1.16)", "l2_curvature", &Errors::laplacian}}};
    return all;
}

class InterpolationFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        plot::Figure figure{"interpolation", 2, 3};
        figure.panel_width = 330;
        figure.panel_height = 250;
        const Errors even = row(figure, 0, Arrangement::even, run);
        const Errors jittered = row(figure, 1, Arrangement::jittered, run);
        run.save(figure);
        report::Table table{{"estimate", "equation", "even particles", "jittered particles"}};
        for (const Line& line : lines()) {
            table.row({line.name, line.equation, report::number(even.*line.error, 2),
                       report::number(jittered.*line.error, 2)});
            run.result("even", options_.particles, line.quantity, even.*line.error);
            run.result("jittered", options_.particles, line.quantity, jittered.*line.error);
        }
        run.fill("interpolation", table.markdown());
        run.claim(
            "constants-cost", [&] { return jittered.plain > 10 * jittered.gradient; },
            report::Needs::any_run);
        run.claim(
            "volume-beats-mass", [&] { return jittered.weighted > 2 * jittered.gradient; },
            report::Needs::any_run);
        run.claim(
            "even-agree",
            [&] { return even.plain < 1.1 * even.gradient && even.weighted < 1.1 * even.gradient; },
            report::Needs::any_run);
    }

  private:
    Errors row(plot::Figure& figure, int row, Arrangement arrangement, const report::Run& run) const {
        const auto estimates = estimates_at_particles<1>(options_.setting(arrangement, run));
        draw_row(figure, row, Profile{estimates});
        // The second row has the same entries, and less room for them.
        for (const int column : {0, 1, 2}) figure.at(row, column).legend.shown = row == 0;
        const std::string particles = arrangement == Arrangement::even ? "even" : "jittered";
        figure.at(row, 1).titled(particles + " particles, " + kernel_label(options_.kernel));
        return errors_of(estimates);
    }

    ParticleOptions options_;
};

}  // namespace

report::Task interpolation() {
    return InterpolationFigure{};
}

}  // namespace sph::interpolation
