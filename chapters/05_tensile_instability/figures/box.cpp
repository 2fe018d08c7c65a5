#include <algorithm>

#include "chapters/05_tensile_instability/scenes/held_box.hpp"
#include "common/plot/looks.hpp"
#include "common/report/chapter.hpp"

namespace sph::tensile {
namespace {

void draw_particles(plot::Panel& panel, const HeldBoxRun& one, const std::string& title) {
    panel.titled(title).labels("$x$ / d$x$", "$y$ / d$x$");
    panel.equal_aspect = true;
    panel.points(one.fixed[0], one.fixed[1],
                 {.label = "fixed",
                  .colour = plot::Colour{0.72, 0.72, 0.72},
                  .marker = plot::Marker::circle,
                  .marker_size = 3});
    panel.points(
        one.shown[0], one.shown[1],
        {.label = "free", .colour = plot::cycle(0), .marker = plot::Marker::circle, .marker_size = 3});
    panel.x_range(2, 28).y_range(2, 28);
    panel.legend.shown = false;
}

}  // namespace

void box(report::Run& run) {
    HeldBox scene;
    scene.threads = run.threads();
    if (run.quick()) scene.time = 22;
    plot::Figure figure{"box", 1, 3};
    plot::Panel& over_time =
        figure.at(0, 2).log_y().titled("farthest from its place").labels("$t c$ / d$x$", "distance / d$x$");
    std::vector<HeldBoxRun> runs;
    std::size_t look = 1;
    for (const double P : {-0.2, -0.05, 0.2}) {
        scene.pressure = P;
        runs.push_back(run_held_box(scene));
        const HeldBoxRun& one = runs.back();
        over_time.curve(one.t, one.farthest,
                        {.label = "$P$ = " + report::number(P, 1), .colour = plot::cycle(look++)});
        run.record("P = " + report::number(P, 1), scene.free_side,
                   {{"clumped_at", one.clumped_at, "dx/c"},
                    {"nearest", one.nearest, "dx"},
                    {"farthest", one.farthest.back(), "dx"}});
    }
    draw_particles(figure.at(0, 0), runs[0], "tension, $P$ = −0.2");
    draw_particles(figure.at(0, 1), runs[2], "pressure, $P$ = 0.2");
    plot::draw_exact(
        over_time, 0.2, scene.time, [&](double t) { return scene.push * t; }, plot::exact("the push alone"));
    run.save(figure);
    run.fill("box-clumped", report::fixed(runs[0].clumped_at, 0));
    run.claim(
        "box-clumps", [&] { return runs[0].clumped_at > 0 && runs[0].clumped_at < 20; },
        report::Needs::any_run);
    run.claim(
        "box-rests",
        [&] {
            return runs[2].clumped_at == 0 &&
                   *std::max_element(runs[2].farthest.begin(), runs[2].farthest.end()) < 0.01;
        },
        report::Needs::any_run);
}

}  // namespace sph::tensile
