#include "chapters/07_godunov_sph/scenes/wedge_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "common/app/error.hpp"
#include "common/plot/looks.hpp"

namespace sph::godunov {

void draw_mach(plot::Panel& panel, const WedgeChannel& channel, const ChannelFlow& flow, bool bar) {
    constexpr int rows = 40;  // of the picture, and three times as many columns
    constexpr double lowest = 0.46, step = 0.025;
    constexpr int levels = 22;
    plot::Field field{.name = "mach", .contours = {}};
    const double half = 0.5 / rows;
    for (int k = 0; k < 3 * rows; ++k) field.x.push_back(channel.begin + 2 * half * (k + 0.5));
    for (int k = 0; k < rows; ++k) field.y.push_back(2 * half * (k + 0.5));
    for (const double y : field.y) {
        for (const double x : field.x) field.value.push_back(flow.mach_at(x, y));
    }
    for (int k = 0; k < levels; ++k) field.contours.push_back(channel.mach * (lowest + step * k));
    field.bar = {.label = "Mach number", .range = std::array{channel.mach * 0.3, channel.mach}, .shown = bar};
    panel.field(field);
    const plot::Values corners{channel.edge, channel.corner, channel.end};
    const plot::Values zero(3, 0.0);
    plot::Values floor;
    for (const double x : corners) floor.push_back(channel.floor(x));
    panel.band(corners, zero, floor).colour = plot::Colour{0.6, 0.6, 0.6};
    panel.labels("$x$", "$y$").x_range(channel.begin, channel.end).y_range(0, 1);
    panel.equal_aspect = true, panel.grid = false;
}

WedgeCommand::WedgeCommand() : method_{channel_methods(), {}, {0.9, 2}} {}

void WedgeCommand::declare(app::CommandLine& line) {
    line.number("mach", scene_.channel.mach, {1.2, 10}, "", "Mach number of the gas that enters")
        .number("angle", scene_.channel.angle, {0.1, 40}, "degrees",
                "of the wedge; the shock must be attached")
        .number("gamma", scene_.channel.gamma, {1.05, 3}, "", "adiabatic index")
        .integer("cells", cells_, 12, 128, "particles across the stream; three times as many along it")
        .number("times", scene_.times, {0.1, 20}, "", "how often the stream passes through the channel")
        .number("courant", scene_.courant, {0.01, 0.6}, "", "step over the shortest time between neighbours")
        .choice("walls", walls_, {"mirrors", "none"}, "what stands behind the walls");
    method_.declare(line);
}

void WedgeCommand::run(report::Run& run) const {
    if (method_.wants_list()) return run.print(channel_methods().text());
    const ChannelMethod method = method_.chosen();
    const double largest = exact::ObliqueShock::largest_angle(scene_.channel.mach, scene_.channel.gamma) *
                           180 / std::numbers::pi;
    if (scene_.channel.angle > largest)
        throw app::UsageError{fmt::format(
            "--angle: {} is not allowed; allowed: 0.1..{:.4g} (theta_max at Mach {}): the shock of a blunter "
            "wedge is detached",
            scene_.channel.angle, largest, scene_.channel.mach)};
    report::tell(run, method);
    WedgeScene scene = scene_;
    scene.cells = static_cast<std::size_t>(cells_), scene.threads = run.threads();
    scene.mirrors = walls_ == "mirrors", scene.progress = run.progress();
    const WedgeRun wedge = run_wedge(scene, method);
    run.record(method.name, scene.cells, wedge.quantities());
    const exact::ObliqueShock shock = scene.channel.shock();
    run.record("exact", scene.cells,
               {{"shock_angle", shock.beta() * 180 / std::numbers::pi, "degrees"},
                {"mach_behind_shock", shock.mach_behind()},
                {"mach_after_fan", scene.channel.fan().mach_behind()}});
    run.write("profile.csv", report::csv({{"x", wedge.x[0]},
                                          {"y", wedge.x[1]},
                                          {"rho", wedge.rho},
                                          {"v_x", wedge.v[0]},
                                          {"v_y", wedge.v[1]},
                                          {"p", wedge.p},
                                          {"mach", wedge.mach}}));
    plot::Figure figure{"wedge", 1, 1};
    figure.panel_width = 700;
    draw_mach(figure.at(0, 0), scene.channel, wedge.flow, true);
    run.save(figure);
}

}  // namespace sph::godunov
