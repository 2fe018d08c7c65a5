#include <cmath>

#include "chapters/08_landau_model/scenes/slab.hpp"
#include "common/exact/landau.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"

/// The slab in the plane of place and time: its edges, waves and regions, and some of its particles.
namespace sph::landau {
namespace {

constexpr double last_time = 5;
const plot::Style wave_line{.colour = plot::black, .layer = 2};

/// A wave on both sides; `place` gives it on the right.
void draw_wave(plot::Panel& panel, double from, double to, const plot::Style& style, auto&& place) {
    constexpr int points = 101;
    for (const double side : {-1.0, 1.0}) {
        plot::Values x, t;
        for (int k = 0; k < points; ++k) {
            t.push_back(from + (to - from) * k / (points - 1));
            x.push_back(side * place(t.back()));
        }
        panel.curve(x, t, style);
    }
}

void draw_waves(plot::Panel& panel) {
    const double meeting = exact::LandauSlab::meeting_time;
    plot::Style dashed = wave_line;
    dashed.dash = plot::Dash::dashed;
    draw_wave(panel, 0, last_time, wave_line, [](double t) { return 1 + t; });
    draw_wave(panel, 0, meeting, dashed, [&](double t) { return 1 - t / meeting; });
    draw_wave(panel, meeting * (1 + 1e-9), last_time, dashed,
              [](double t) { return exact::LandauSlab{t}.matching(); });
}

void name_regions(plot::Panel& panel) {
    const auto note = [&](double x, double t, const char* text) {
        plot::Note& one = panel.note(x, t, text);
        one.anchor = plot::Anchor::centre;
        one.size = 9;
    };
    note(0, 0.35, "at rest"), note(0, 4.2, "Khalatnikov");
    for (const double side : {-1.0, 1.0})
        note(side * 2.35, 3.0, "simple wave"), note(side * 4.6, 1.2, "vacuum");
    panel.note(1.5, 0.12, "edge: $x$ = 1 + $t$").points_at = std::array{1.5, 0.5};
    panel.note(-3.9, 0.35, "head of the wave").points_at = std::array{-0.77, 0.4};
    panel.note(-5.9, 2.4, "weak discontinuity").points_at = std::array{-0.47, 2.4};
}

}  // namespace

void x_t(report::Run& run) {
    constexpr std::size_t stride = 3;
    const int looks = run.quick() ? 21 : 61;
    SlabScene scene{.n = 120, .times = {}, .courant = SlabScene::fast_courant};
    for (int k = 0; k < looks; ++k) scene.times.push_back(last_time * k / (looks - 1));
    const auto profiles = run_slab(scene, slab_methods().recommended());

    plot::Figure figure{"x-t"};
    figure.panel_width = 640;
    plot::Panel& panel =
        figure.panel().labels("$x$", "$t$").x_range(-1 - last_time, 1 + last_time).y_range(0, last_time);
    panel.legend.shown = false;
    for (std::size_t i = 1; i < scene.n; i += stride) {
        plot::Values x;
        for (const SlabProfile& profile : profiles) x.push_back(profile.x[i]);
        panel.curve(x, scene.times, plot::rest());
    }
    draw_waves(panel);
    name_regions(panel);
    run.save(figure);
    run.claim(
        "inside-the-cone",
        [&] {
            for (const SlabProfile& profile : profiles) {
                if (!(profile.edge_gap > 0)) return false;
            }
            return true;
        },
        report::Needs::any_run);
}

}  // namespace sph::landau
