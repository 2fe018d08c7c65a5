#include <cmath>

#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {
namespace {

void draw_places(plot::Panel& panel, const PlaneMethod& method, std::size_t n, double low) {
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    const auto fluid = plane_fluid(flow, {.n = n, .times = {}}, method);
    const auto& x = fluid->get<Position>();
    plot::Values X, Y;
    constexpr double side = 4;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        if (x[0][i] > low && x[0][i] < low + side && std::abs(x[1][i]) < side / 2)
            X.push_back(x[0][i]), Y.push_back(x[1][i]);
    }
    panel.titled(method.label).labels("$x$", "").x_range(low, low + side).y_range(-side / 2, side / 2);
    panel.equal_aspect = true;
    panel.points(X, Y, plot::dots({.colour = plot::cycle(0), .marker = plot::Marker::circle}, 3));
}

}  // namespace

/// Where particles begin decides what reaches the axis.
void places(report::Run& run) {
    plot::Figure figure{"places", 2, 3};
    figure.panel_width = 280, figure.panel_height = 250;
    const std::size_t shown = run.quick() ? 500 : 2500;
    const std::vector<std::string> drawn{"hexagonal", "rings", "relaxed", "spiral", "spiral-graded"};
    for (std::size_t k = 0; k < drawn.size(); ++k)
        draw_places(figure.at(static_cast<int>(k / 3), static_cast<int>(k % 3)), plane_methods()[drawn[k]],
                    shown, 6.5);
    plot::Panel& inner = figure.at(1, 2);
    draw_places(inner, plane_methods()["rings"], shown, -2);
    inner.titled("rings, at the axis");
    run.save(figure);
}

}  // namespace sph::transverse
