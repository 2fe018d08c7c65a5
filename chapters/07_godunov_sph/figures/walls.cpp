#include "chapters/07_godunov_sph/scenes/wedge.hpp"
#include "common/plot/looks.hpp"

namespace sph::godunov {
namespace {

constexpr double left = -0.85, right = 0.3, lowest = -0.22, highest = 0.42;  // of the picture

/// Those of the points that the picture shows.
void draw_points(plot::Panel& panel, const Columns<2>& x, plot::Style look) {
    plot::Values px, py;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        if (x[0][i] < left || x[0][i] > right || x[1][i] < lowest || x[1][i] > highest) continue;
        px.push_back(x[0][i]), py.push_back(x[1][i]);
    }
    panel.points(px, py, std::move(look));
}
/// The line behind a corner that divides the images of both pieces.
void draw_division(plot::Panel& panel, const PolygonWall::Piece& piece, const std::string& label) {
    constexpr double length = 0.3;
    const double size = std::hypot(piece.to[0], piece.to[1]);
    panel.curve({piece.end[0], piece.end[0] + length * piece.to[1] / size},
                {piece.end[1], piece.end[1] - length * piece.to[0] / size},
                {.label = label, .colour = plot::black, .dash = plot::Dash::dashed, .width = 1});
}

}  // namespace

void walls(report::Run& run) {
    WedgeScene scene;
    scene.cells = 16, scene.times = run.quick() ? 0.3 : 1.5, scene.threads = run.threads();
    const WedgeRun wedge = run_wedge(scene, channel_methods()["godunov"]);
    const OpenChannel channel{scene.channel.walls(), 1.0 / 16};
    std::vector<Ghost<2>> ghosts;
    channel.add_ghosts(wedge.x, 0.22, ghosts);
    Columns<2> images;
    std::size_t twice = 0;
    for (const Ghost<2>& ghost : ghosts) {
        images[0].push_back(ghost.x[0]), images[1].push_back(ghost.x[1]);
        twice += channel.walls[0].behind(ghost.x) && channel.walls[1].behind(ghost.x) ? 1 : 0;
    }
    plot::Figure figure{"walls", 1, 1};
    figure.panel_width = 640;
    plot::Panel& panel = figure.panel().labels("$x$", "$y$").x_range(left, right).y_range(lowest, highest);
    panel.equal_aspect = true, panel.grid = false;
    const std::vector<PolygonWall::Piece>& pieces = channel.walls[0].pieces();
    panel.curve({left, pieces[1].begin[0], pieces[1].end[0], right},
                {0, pieces[1].begin[1], pieces[1].end[1], pieces[1].end[1]},
                {.label = "wall", .colour = plot::black, .width = 2});
    draw_points(panel, wedge.x, {.label = "particles", .marker = plot::Marker::circle, .marker_size = 4});
    draw_points(panel, images, {.label = "images", .marker = plot::Marker::cross, .marker_size = 4});
    draw_division(panel, pieces[0], "division of images");
    draw_division(panel, pieces[1], "");
    panel.legend.outside = true;
    run.save(figure);
    run.record("godunov", scene.cells, {{"images", static_cast<double>(ghosts.size())}});
    run.claim(
        "walls-once", [&] { return twice == 0 && wedge.through == 0; }, report::Needs::any_run);
}

}  // namespace sph::godunov
