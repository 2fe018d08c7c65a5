#include "chapters/03_euler_sph/scenes/patch.hpp"

#include <cmath>

#include "common/plot/looks.hpp"

namespace sph::euler {
namespace {

/// How many of the particles at the square's corners end within a twentieth of its side from where they
/// began.
int corners_that_stay(const PatchRun& liquid, std::size_t per_side) {
    const double end = 0.5 - 0.5 / static_cast<double>(per_side);
    int stay = 0;
    for (const std::size_t row : {std::size_t{0}, per_side - 1}) {
        for (const std::size_t column : {std::size_t{0}, per_side - 1}) {
            const std::size_t i = row * per_side + column;
            const double x = liquid.x[0][i], y = liquid.x[1][i];
            stay += std::hypot(std::abs(x) - end, std::abs(y) - end) < 0.05 ? 1 : 0;
        }
    }
    return stay;
}

}  // namespace

void patch(report::Run& run) {
    plot::Figure figure{"patch", 1, 3};
    figure.panel_width = 330;
    PatchScene scene;
    scene.threads = run.threads();
    if (run.quick()) scene.per_side = 24;
    const PatchRun liquid = run_patch(scene);
    const auto discs = [&](int column, const std::string& title, const Columns<2>& x, const Column& pressure,
                           bool bar) {
        plot::Panel& panel = figure.at(0, column).titled(title).labels("$x$", "$y$");
        panel.equal_aspect = true;
        panel.x_range(-0.6, 1.1).y_range(-1.1, 0.6);
        panel.curve({-0.5, 0.5, 0.5, -0.5, -0.5}, {-0.5, -0.5, 0.5, 0.5, -0.5},
                    {.colour = plot::black, .width = 1});
        panel.particles({.name = "pressure",
                         .x = x[0],
                         .y = x[1],
                         .value = pressure,
                         .diameter = 3.5,
                         .bar = {.label = "$P$ / ρ_{0}$V$^{2}",
                                 .map = plot::Map::blue_red,
                                 .range = std::array{-1.0, 1.0},
                                 .shown = bar}});
    };
    discs(0, "$t$ = 0.3 $L$/$V$", liquid.middle_x, liquid.middle_pressure, false);
    discs(1, "$t$ = 0.6 $L$/$V$", liquid.x, liquid.pressure, true);
    plot::Panel& right = figure.at(0, 2).titled("energy").labels("$t$ $V$/$L$", "10^{9} Δ$E$ / $E$");
    plot::Values change;
    for (const double value : liquid.energy) change.push_back(1e9 * value);
    right.curve(liquid.t, change, {.label = ""});
    run.save(figure);
    run.record("phi-one", scene.per_side * scene.per_side, liquid.measured());
    run.fill("patch-energy",
             liquid.energy_drift < 1e-7 ? "less than 10⁻⁷" : report::number(liquid.energy_drift, 1));
    run.claim("corners-stay", [&] { return corners_that_stay(liquid, scene.per_side) == 3; });
    run.claim("patch-conserves", [&] {
        return liquid.energy_drift < 1e-7 && liquid.momentum < 1e-12 && liquid.angular_momentum < 1e-12;
    });
    run.fill("patch-compression", report::number(100 * liquid.compression, 1));
}

}  // namespace sph::euler
