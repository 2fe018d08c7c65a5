#include "chapters/04_artificial_viscosity/figures/plane.hpp"

#include <algorithm>

#include "common/plot/looks.hpp"

namespace sph::shocks {

void draw_map(plot::Panel& panel, const PlaneField& field, double side, double highest, double diameter) {
    panel.labels("$x$", "$y$").x_range(0, side).y_range(0, side);
    panel.equal_aspect = true;
    plot::Discs discs{.name = "density", .diameter = diameter, .bar = {.label = "ρ"}};
    discs.bar.range = std::array{0.0, highest};
    for (std::size_t i = 0; i < field.r.size(); ++i) {
        if (!(field.x[0][i] <= side && field.x[1][i] <= side)) continue;
        discs.x.push_back(field.x[0][i]);
        discs.y.push_back(field.x[1][i]);
        discs.value.push_back(std::min(field.rho[i], highest));
    }
    panel.particles(discs);
}

void draw_profile(plot::Panel& panel, const PlaneField& field, double r_end, const plot::Style& look) {
    plot::Values r, rho;
    for (std::size_t i = 0; i < field.r.size(); ++i) {
        if (field.r[i] >= r_end) continue;
        r.push_back(field.r[i]);
        rho.push_back(field.rho[i]);
    }
    panel.points(r, rho, plot::dots(look, 2.5));
}

}  // namespace sph::shocks
