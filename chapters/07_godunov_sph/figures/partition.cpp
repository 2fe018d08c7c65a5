#include <algorithm>

#include "chapters/07_godunov_sph/scenes/uniform_pressure.hpp"
#include "common/plot/looks.hpp"
#include "common/report/chapter.hpp"

namespace sph::godunov {

void partition(report::Run& run) {
    const Partition sums = partition(Resting{.n = 20, .jitter = 0.3, .seed = 3});
    plot::Figure figure{"partition", 1, 2};
    plot::Panel& one = figure.at(0, 0).labels("$x$ / d$x$", "what should be 1").x_range(4, 16);
    one.curve(sums.x, sums.approximate,
              {.label = "Σ $m$_{j} $W$ / ρ_{j}", .colour = plot::cycle(1), .width = 2});
    one.curve(sums.x, sums.exact, {.label = "Σ $m$_{j} $W$ / ρ($x$)", .colour = plot::cycle(0), .width = 2});
    one.points(sums.particles, plot::Values(sums.particles.size(), 0.9),
               {.label = "particles", .colour = plot::black, .marker = plot::Marker::circle});
    one.y_range(0.88, 1.14);
    plot::Panel& field = figure.at(0, 1).labels("$x$ / d$x$", "velocity").x_range(4, 16);
    field.curve(sums.x, sums.field, {.label = "$v$($x$)", .colour = plot::cycle(0), .width = 2});
    field.points(sums.particles, sums.velocities,
                 {.label = "particles", .colour = plot::black, .marker = plot::Marker::circle});
    run.save(figure);
    const auto [low, high] = std::minmax_element(sums.approximate.begin(), sums.approximate.end());
    run.claim(
        "not-a-partition", [&] { return *high - *low > 0.05; }, report::Needs::any_run);
}

}  // namespace sph::godunov
