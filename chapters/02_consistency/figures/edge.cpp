#include <cmath>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/edge_line.hpp"
#include "common/plot/looks.hpp"

/// The chapter's first picture: a support that an end has cut, and what a sum makes of the constant 1 there.
namespace sph::consistency {
namespace {

void draw_plane(plot::Panel& panel, std::uint64_t seed) {
    constexpr std::size_t side = 14, centre = 6 * side;  // in the column nearest to the left edge
    panel.curve({0, 0}, {0.1, 0.9}, {.colour = plot::black, .width = 1.5});
    interpolation::draw_support(panel, make_points<2>(Arrangement::jittered, side, 0.2, seed), centre,
                                2.4 / side, false);
    panel.titled("a support that the end has cut").x_range(-0.25, 0.55).y_range(0.1, 0.9);
    panel.note(-0.23, 0.85, "nobody here");
}

void draw_line(plot::Panel& panel, std::uint64_t seed) {
    const plot::Values place = linear_space(0, 0.5, 251);
    const auto sum = [&](Arrangement arrangement) {
        const EdgeLine line{{.arrangement = arrangement, .per_side = 40, .jitter = 0.3, .seed = seed}};
        plot::Values values;
        for (const double p : place) values.push_back(line.constant(p));
        return values;
    };
    panel.titled("the constant 1").labels("$x$", "$A$").x_range(0, 0.5).y_range(0, 1.4);
    panel.curve(place, sum(Arrangement::even), {.label = "even particles", .colour = plot::cycle(2)});
    panel.curve(place, sum(Arrangement::jittered), {.label = "disordered ones", .colour = plot::cycle(1)});
    plot::draw_exact(panel, 0, 0.5, [](double) { return 1.0; });
}

}  // namespace

void edge(report::Run& run) {
    plot::Figure figure{"edge", 1, 2};
    figure.panel_width = 330;
    figure.panel_height = 300;
    draw_plane(figure.at(0, 0), run.seed());
    draw_line(figure.at(0, 1), run.seed());
    run.save(figure);
}

}  // namespace sph::consistency
