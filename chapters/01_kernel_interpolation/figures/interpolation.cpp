#include <algorithm>
#include <numeric>

#include "chapters/01_kernel_interpolation/scenes/measured.hpp"
#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/report/norms.hpp"

namespace sph {
namespace {

/// The estimates as curves, from left to right.
struct Profile {
    plot::Values x, value, plain, gradient, weighted, twice, laplacian;
    explicit Profile(const Estimates<1>& e) {
        std::vector<std::size_t> order(e.x.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return e.x[i][0] < e.x[j][0]; });
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

void draw_row(plot::Figure& figure, int row, const Profile& e) {
    using plot::Marker;
    const plot::Values x = linear_space(0, 1, 401);
    plot::Values value, slope, curvature;
    for (const double position : x) {
        value.push_back(TestFunction<1>::value({position}));
        slope.push_back(TestFunction<1>::gradient({position})[0]);
        curvature.push_back(TestFunction<1>::laplacian({position}));
    }
    const plot::Style exact{.label = "exact", .colour = plot::Colour{0, 0, 0}, .width = 1.2};
    const auto dots = [](std::string label, std::size_t colour, Marker marker, bool filled = true) {
        return plot::Style{.label = std::move(label),
                           .colour = plot::cycle(colour),
                           .marker = marker,
                           .marker_size = 4.5,
                           .filled = filled,
                           .layer = 2};
    };
    plot::Panel& left = figure.at(row, 0).labels("$x$", "$A$").x_range(0, 1);
    left.curve(x, value, exact);
    left.points(e.x, e.value, dots("(2.8)", 0, Marker::circle));
    plot::Panel& middle = figure.at(row, 1).labels("$x$", "d$A$/d$x$").x_range(0, 1).y_range(-14, 14);
    middle.curve(x, slope, exact);
    middle.points(e.x, e.plain, dots("(2.11)", 1, Marker::square, false));
    middle.points(e.x, e.gradient, dots("(2.14)", 0, Marker::circle));
    middle.points(e.x, e.weighted, dots("(2.15)", 2, Marker::triangle_up, false));
    plot::Panel& right =
        figure.at(row, 2).labels("$x$", "d^{2}$A$/d$x$^{2}").x_range(0, 1).y_range(-300, 200);
    right.curve(x, curvature, exact);
    right.points(e.x, e.twice, dots("twice differentiated (2.21)", 1, Marker::square, false));
    right.points(e.x, e.laplacian, dots("Brookshaw (2.24)", 0, Marker::circle));
}

}  // namespace

void test_function(report::Run& run, const Options& options) {
    plot::Figure figure{"interpolation", 2, 3};
    figure.panel_width = 330;
    figure.panel_height = 250;
    Setting setting{options.kernel,    Arrangement::even, static_cast<std::size_t>(options.particles),
                    options.h_over_dx, options.jitter,    run.seed(),
                    run.threads()};
    std::vector<Errors> errors;
    int row = 0;
    for (const std::string arrangement : {"even", "jittered"}) {
        setting.arrangement = arrangement_named(arrangement);
        const auto estimates = estimates_at_particles<1>(setting);
        draw_row(figure, row, Profile{estimates});
        // The second row has the same entries, and less room for them.
        for (const int column : {0, 1, 2}) figure.at(row, column).legend.shown = row == 0;
        figure.at(row++, 1).titled(arrangement + " particles, " + kernel_label(options.kernel));
        errors.push_back(errors_of(estimates));
    }
    struct Line {
        std::string name, equation, quantity;
        double Errors::*error;
    };
    const std::array<Line, 6> lines{
        {{"A", "2.8", "l2_value", &Errors::value},
         {"dA/dx", "2.11", "l2_slope_plain", &Errors::plain},
         {"dA/dx, Φ = 1", "2.14", "l2_slope", &Errors::gradient},
         {"dA/dx, Φ = ρ", "2.15", "l2_slope_weighted", &Errors::weighted},
         {"d²A/dx², twice differentiated", "2.21", "l2_curvature_twice", &Errors::twice},
         {"d²A/dx², Brookshaw", "2.24", "l2_curvature", &Errors::laplacian}}};
    report::Table table{{"estimate", "equation", "even particles", "jittered particles"}};
    for (const Line& line : lines) {
        const double even = errors[0].*line.error, jittered = errors[1].*line.error;
        table.row({line.name, line.equation, report::number(even, 2), report::number(jittered, 2)});
        run.result("even", options.particles, line.quantity, even);
        run.result("jittered", options.particles, line.quantity, jittered);
    }
    run.save(figure);
    run.fill("interpolation", table.markdown());
}

void interpolation_map(report::Run& run, const Options& options) {
    plot::Figure figure{"map", 1, 2};
    figure.panel_width = 330;
    figure.panel_height = 330;
    const std::size_t pixels = run.quick() ? 61 : 101;
    plot::Field value{
        .name = "interpolant", .x = linear_space(0, 1, pixels), .y = linear_space(0, 1, pixels)};
    Columns<2> positions;
    for (const double y : value.y) {
        for (const double x : value.x) {
            positions[0].push_back(x);
            positions[1].push_back(y);
        }
    }
    const Map map =
        interpolate_at({options.kernel, Arrangement::jittered, static_cast<std::size_t>(options.particles),
                        options.h_over_dx, options.jitter, run.seed()},
                       positions);
    value.value = map.value;
    plot::Field error = value;
    plot::Values exact;
    double largest = 0;
    for (std::size_t k = 0; k < positions[0].size(); ++k) {
        exact.push_back(TestFunction<2>::value({positions[0][k], positions[1][k]}));
        error.value[k] -= exact[k];
        largest = std::max(largest, std::abs(error.value[k]));
    }
    value.bar.label = "$A$";
    value.contours = linear_space(-2.5, 2.5, 11);
    error.name = "error";
    error.bar = {.label = "interpolant − exact", .map = plot::Map::blue_red};
    error.bar.range = {-largest, largest};
    figure.at(0, 0).titled("interpolant, " + kernel_label(options.kernel)).field(value);
    figure.at(0, 1).titled("its error, and the particles").field(error);
    figure.at(0, 1).points(
        map.particles[0], map.particles[1],
        {.colour = plot::Colour{0, 0, 0}, .marker = plot::Marker::circle, .marker_size = 1.2});
    const double l2 = report::l2_error(map.value, exact);
    run.result(options.kernel, options.particles * options.particles, "l2_value_map", l2);
    run.fill("map-error", report::number(100 * l2, 2));
    for (int column : {0, 1}) {
        figure.at(0, column).labels("$x$", column == 0 ? "$y$" : "").x_range(0, 1).y_range(0, 1);
        figure.at(0, column).equal_aspect = true;
        figure.at(0, column).grid = false;
    }
    run.save(figure);
}

}  // namespace sph
