#include <algorithm>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/two_errors.hpp"
#include "common/plot/method_looks.hpp"

/// Smoothing and sampling, pulled apart: errors of a wave against h.
namespace sph::interpolation {
namespace {

struct Curves {
    plot::Values smoothing, sampling, measured;
};

Curves scan(report::Run& run, const plot::Values& h_over_dx, Arrangement arrangement, std::size_t n) {
    Curves curves;
    for (const double h : h_over_dx) {
        const WaveErrors e = wave_errors({.arrangement = arrangement,
                                          .per_side = n,
                                          .h_over_dx = h,
                                          .seed = run.seed(),
                                          .threads = run.threads()});
        curves.smoothing.push_back(e.smoothing);
        curves.sampling.push_back(e.sampling);
        curves.measured.push_back(e.measured);
    }
    return curves;
}

void draw(plot::Panel& panel, const plot::Values& h, const Curves& c, std::size_t n, plot::Marker marker,
          bool first) {
    const std::string size = "$N$ = " + std::to_string(n);
    const plot::Dash dash = first ? plot::Dash::solid : plot::Dash::dashed;
    panel.curve(h, c.smoothing, {.label = "smoothing, " + size, .colour = plot::cycle(2), .dash = dash});
    if (first) panel.curve(h, c.sampling, {.label = "sampling", .colour = plot::cycle(1)});
    panel.points(h, c.measured,
                 {.label = "sum, " + size, .colour = plot::cycle(0), .marker = marker, .marker_size = 4});
}

}  // namespace

void two_errors(report::Run& run) {
    plot::Figure figure{"two-errors", 1, 2};
    figure.panel_width = 330;
    const plot::Values h = log_space(0.7, 8, run.quick() ? 22 : 64);
    const Curves even = scan(run, h, Arrangement::even, 32), few = scan(run, h, Arrangement::jittered, 32),
                 many = scan(run, h, Arrangement::jittered, 512);
    draw(figure.at(0, 0), h, even, 32, plot::Marker::circle, true);
    draw(figure.at(0, 1), h, few, 32, plot::Marker::circle, true);
    draw(figure.at(0, 1), h, many, 512, plot::Marker::square, false);
    for (const int column : {0, 1}) {
        plot::Panel& panel =
            figure.at(0, column).log_log().labels("$h$/d$x$", column == 0 ? "relative error of a wave" : "");
        panel.titled(column == 0 ? "even particles" : "disordered particles");
        panel.y_range(1e-6, 1).x_range(0.7, 8);
        panel.x.ticks = {1, 2, 4, 8};
    }
    run.save(figure);
    run.claim(
        "two-errors-add",
        [&] {
            double worst = 0;
            for (std::size_t k = 0; k < h.size(); ++k) {
                // signs: smoothing is negative, sampling has either
                const double apart =
                    std::min(std::abs(even.measured[k] - even.smoothing[k] - even.sampling[k]),
                             std::abs(even.measured[k] - std::abs(even.smoothing[k] - even.sampling[k])));
                worst = std::max(worst, apart);
            }
            return worst < 1e-12;
        },
        report::Needs::any_run);
    run.claim(
        "sampling-knows-no-n",
        [&] {
            for (std::size_t k = 0; k < h.size(); ++k) {
                const double ratio = few.sampling[k] / many.sampling[k];
                if (ratio < 0.6 || ratio > 1.6) return false;
            }
            return true;
        },
        report::Needs::any_run);
    run.claim(
        "best-h-moves",
        [&] {
            const auto best = [&](const Curves& c) {
                return h[static_cast<std::size_t>(std::min_element(c.measured.begin(), c.measured.end()) -
                                                  c.measured.begin())];
            };
            return best(many) > 2 * best(few);
        },
        report::Needs::any_run);
}

}  // namespace sph::interpolation
