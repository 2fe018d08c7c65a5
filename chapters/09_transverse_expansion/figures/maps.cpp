#include "chapters/09_transverse_expansion/scenes/expansion.hpp"

namespace sph::transverse {

/// The opening picture: particles of the cylinder, coloured by their temperature.
void maps(report::Run& run) {
    const std::vector<double> times{1.01, 5, 15};
    const PlaneScene scene{.n = run.quick() ? 400UL : 2500UL, .times = times};
    const auto shots = run_plane(cylinder(10, 1, 1.0 / 3), scene, plane_methods().recommended());
    plot::Figure figure{"maps", 1, 3};
    figure.panel_width = 300, figure.panel_height = 280;
    constexpr double reach = 25;
    for (std::size_t k = 0; k < shots.size(); ++k) {
        const Snapshot& shot = shots[k];
        plot::Panel& panel = figure.at(0, static_cast<int>(k));
        panel.titled("τ = " + report::number(shot.time, 2)).labels("$x$", k == 0 ? "$y$" : "");
        panel.x_range(-reach, reach).y_range(-reach, reach);
        panel.equal_aspect = true;
        plot::Discs discs{"particles", shot.x, shot.y, shot.temperature, 1.8, 0, {}};
        discs.bar = {"$T$/$T$_{0}", plot::Map::magma, std::array{0.05, 1.1}, plot::Scale::log, k == 2};
        panel.particles(discs);
    }
    run.save(figure);
}

}  // namespace sph::transverse
