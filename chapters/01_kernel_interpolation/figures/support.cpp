#include <cmath>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "chapters/01_kernel_interpolation/scenes/two_errors.hpp"
#include "common/core/arrangement.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"

/// The chapter's first picture: who is summed, and what is summed.
namespace sph::interpolation {
namespace {

constexpr double h_over_dx = 1.2, reach_over_h = 2;

plot::Style spot(plot::Colour colour, std::string label, double size) {
    return {.label = std::move(label), .colour = colour, .marker = plot::Marker::circle, .marker_size = size};
}

/// Particles in the plane, one of them, its support and its neighbours.
void draw_plane(plot::Panel& panel, std::uint64_t seed) {
    constexpr std::size_t side = 12, centre = 5 * side + 6;
    const Columns<2> x = make_points<2>(Arrangement::jittered, side, 0.2, seed);
    const double reach = reach_over_h * h_over_dx / side;
    plot::Values near_x, near_y, far_x, far_y, circle_x, circle_y;
    for (std::size_t j = 0; j < x[0].size(); ++j) {
        if (j == centre) continue;
        const bool inside = std::hypot(x[0][j] - x[0][centre], x[1][j] - x[1][centre]) < reach;
        (inside ? near_x : far_x).push_back(x[0][j]);
        (inside ? near_y : far_y).push_back(x[1][j]);
    }
    for (const double angle : linear_space(0, 2 * pi, 121)) {
        circle_x.push_back(x[0][centre] + reach * std::cos(angle));
        circle_y.push_back(x[1][centre] + reach * std::sin(angle));
    }
    panel.titled("who is summed").labels("$x$", "$y$").x_range(0, 1).y_range(0, 1);
    panel.equal_aspect = true;
    panel.grid = false;
    panel.points(far_x, far_y, spot({0.6, 0.6, 0.6}, "others", 4));
    panel.curve(circle_x, circle_y, {.label = "support of $i$", .colour = plot::black, .width = 1});
    panel.points(near_x, near_y, spot(plot::cycle(0), "neighbours $j$", 5));
    panel.points({x[0][centre]}, {x[1][centre]}, spot(plot::cycle(1), "particle $i$", 7));
    panel.legend.outside = true;
}

/// Particles on a line, a bump for each, their sum and the function.
void draw_line(plot::Panel& panel, std::uint64_t seed) {
    const Bumps all = bumps(16, h_over_dx, 0.2, seed);
    const plot::Values place = linear_space(0, 1, 241);
    for (std::size_t j = 0; j < all.x.size(); ++j) {
        plot::Values bump;
        for (const double p : place) bump.push_back(all.of(j, p));
        panel.curve(place, bump, plot::rest(j == 0 ? "one particle's part" : ""));
    }
    plot::Values sum, zero(all.x.size(), 0.0);
    for (const double p : place) sum.push_back(all.sum(p));
    panel.curve(place, sum, {.label = "their sum", .colour = plot::cycle(0), .width = 2});
    panel.points(all.x, zero, spot(plot::cycle(0), "", 4));
    plot::draw_exact(panel, 0, 1, [](double x) { return std::exp(std::sin(2 * pi * x)); });
    panel.titled("what is summed").labels("$x$", "$A$").x_range(0, 1).y_range(-0.1, 3);
}

}  // namespace

void support(report::Run& run) {
    plot::Figure figure{"support", 1, 2};
    figure.panel_width = 330;
    figure.panel_height = 300;
    draw_plane(figure.at(0, 0), run.seed());
    draw_line(figure.at(0, 1), run.seed());
    run.save(figure);
}

}  // namespace sph::interpolation
