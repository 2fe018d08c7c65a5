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

/// Particles in the plane, one of them, its support and its neighbours.
void draw_plane(plot::Panel& panel, std::uint64_t seed) {
    constexpr std::size_t side = 12, centre = 5 * side + 6;
    draw_support(panel, make_points<2>(Arrangement::jittered, side, 0.2, seed), centre,
                 reach_over_h * h_over_dx / side, true);
    panel.titled("who is summed").x_range(0, 1).y_range(0, 1).legend.outside = true;
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
