#include "chapters/09_transverse_expansion/scenes/atmosphere.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"

/// A fluid at rest in Rindler's coordinates: its weight, and the sign of it in (322).
namespace sph::transverse {

void atmosphere(report::Run& run) {
    const plot::Style corrected{
        .label = "weight as corrected", .colour = plot::cycle(0), .marker = plot::Marker::circle};
    const plot::Style printed{
        .label = "as printed", .colour = plot::cycle(1), .marker = plot::Marker::square};
    const std::size_t n = run.quick() ? 50 : 100;
    const Atmosphere rests = run_atmosphere({.n = n, .crossings = 3, .samples = 30});
    const Atmosphere flies = run_atmosphere({.n = n, .sign = 1, .crossings = 0.3, .samples = 30});
    const Atmosphere coarse = run_atmosphere({.n = n / 2, .crossings = 0.1, .samples = 1});
    const auto record = [&](const char* name, const Atmosphere& air) {
        run.record(name, n,
                   {{"l1_temperature", air.l1_temperature},
                    {"moved", air.moved.back(), "height"},
                    {"mean_shift", air.mean_shift, "height"}});
    };
    record("corrected", rests);
    record("printed", flies);

    plot::Figure figure{"atmosphere", 1, 2};
    plot::Panel& left = figure.at(0, 0).labels("$x$", "$T$");
    plot::draw_exact(left, 1, 2, [](double x) { return 1 / x; });
    left.points(rests.x, rests.temperature, plot::dots(corrected, 4));
    left.points(flies.x, flies.temperature, plot::dots(printed, 3.5));
    plot::Panel& right = figure.at(0, 1).labels("sound crossings", "largest way / height").log_log();
    right.curve(rests.times, rests.moved, corrected);
    right.curve(flies.times, flies.moved, printed);
    right.legend.shown = false;
    run.save(figure);

    const double most = *std::max_element(rests.moved.begin(), rests.moved.end());
    run.fill("atmosphere-moved", report::below(most));
    run.fill("atmosphere-l1", report::number(100 * rests.l1_temperature, 1));
    run.fill("atmosphere-printed", report::number(100 * flies.moved.back(), 2));
    run.claim("atmosphere-rests", [&] { return most / 3 < 1e-10; });
    run.claim("atmosphere-exact",
              [&] { return rests.l1_temperature < 1e-3 && rests.l1_temperature < coarse.l1_temperature; });
    run.claim("atmosphere-printed", [&] { return flies.moved.back() > 0.1 && flies.mean_shift > 0.05; });
}

}  // namespace sph::transverse
