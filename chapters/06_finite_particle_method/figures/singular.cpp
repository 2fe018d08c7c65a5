#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/report/norms.hpp"

/// Random particles: how many neighbourhoods do not determine a fit, and what is right once they are
/// enlarged.
namespace sph::fpm {

void singular(report::Run& run) {
    plot::Figure figure{"singular", 1, 2};
    plot::Panel& share =
        figure.at(0, 0).log_y().labels("$h$/d$x$", "share of neighbourhoods that are enlarged");
    plot::Panel& error =
        figure.at(0, 1).log_log().labels("particles $N$", "relative $L$_{2} error of the slope");
    const std::size_t sets = run.quick() ? 20 : 100;
    std::size_t left = 0, million = 0;
    double share_at_1 = 0;
    for (const char* name : {"fpm", "sfpm"}) {
        plot::Values h, flagged;
        for (const double h_over_dx : {0.8, 1.0, 1.2, 1.5, 1.8, 2.2}) {
            const auto found = random_neighbourhoods(sets, 1000, h_over_dx, {name, 2}, "quintic", run.seed());
            const double part =
                static_cast<double>(found.enlarged.flagged) / static_cast<double>(found.count);
            if (part > 0) h.push_back(h_over_dx), flagged.push_back(part);
            run.record(name, 1000, {{"enlarged_at_" + report::number(h_over_dx, 2), part}});
            if (h_over_dx >= 1) left += found.enlarged.left, million += found.count;
            if (h_over_dx == 1) share_at_1 = part;
        }
        share.curve(h, flagged, still_methods()[name].styled());
    }
    double worst = 2;
    for (const double h_over_dx : {1.0, 1.5, 3.0}) {
        plot::Values n, off;
        for (const std::size_t size : run.sizes({100, 200, 400}, {100, 200, 400, 800, 1600})) {
            n.push_back(static_cast<double>(size));
            off.push_back(
                random_neighbourhoods(40, size, h_over_dx, {"sfpm", 2}, "quintic", run.seed()).slope_error);
        }
        const double order = report::fitted_order(n, off);
        worst = std::abs(order - 2) > std::abs(worst - 2) ? order : worst;
        run.record("sfpm", static_cast<std::size_t>(n.back()),
                   {{"rate_slope_at_" + report::number(h_over_dx, 2), order}});
        error.curve(n, off,
                    {.label = "$h$/d$x$ = " + report::number(h_over_dx, 2), .marker = plot::Marker::circle});
    }
    error.slope(-2, 200, 1600, 5e-3, "order 2");
    run.fill("enlarged-share", report::number(100 * share_at_1, 1));
    run.claim("none-left", [&] {
        return left == 0 && million >= 1000000 && share_at_1 > 0.005 && share_at_1 < 0.05 &&
               std::abs(worst - 2) < 0.2;
    });
    run.save(figure);
}

}  // namespace sph::fpm
