#include "chapters/04_artificial_viscosity/figures/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
    constexpr std::size_t rings = 50;
    std::array<double, rings> count{}, r{}, sum{}, squares{};
    for (std::size_t i = 0; i < field.r.size(); ++i) {
        if (field.r[i] >= r_end) continue;
        const auto ring = static_cast<std::size_t>(field.r[i] / r_end * rings);
        ++count[ring], r[ring] += field.r[i], sum[ring] += field.rho[i];
        squares[ring] += field.rho[i] * field.rho[i];
    }
    plot::Curve& curve = panel.curve({}, {}, look);
    for (std::size_t k = 0; k < rings; ++k) {
        if (count[k] == 0) continue;
        const double mean = sum[k] / count[k];
        curve.x.push_back(r[k] / count[k]);
        curve.y.push_back(mean);
        curve.error.push_back(std::sqrt(std::max(squares[k] / count[k] - mean * mean, 0.0)));
    }
    curve.style.width = 0.8;
    curve.style.marker_size = 4;
}

}  // namespace sph::shocks
