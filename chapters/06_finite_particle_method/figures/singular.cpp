#include <algorithm>

#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/report/norms.hpp"

/// How well neighbourhoods determine a fit, how many do not, and what is right once they are enlarged.
namespace sph::fpm {
namespace {

const std::vector<double> h_over_dxs{0.8, 1.0, 1.2, 1.5, 1.8, 2.2};

/// Condition numbers of SFPM's matrix: half of all, and 99 of 100, are at most so large; infinite for
/// singular ones.
struct Conditions {
    double median = 0, most = 0;
};
Conditions conditions_of(const report::Run& run, Arrangement arrangement, double h_over_dx) {
    Column all;
    for (std::size_t s = 0; s < (run.quick() ? 2U : 10U); ++s) {
        ParticleSet set = thousand(arrangement);
        set.h_over_dx = h_over_dx, set.seed = run.seed() + s;
        const Column one = interpolate<1>(set, plane_wave<1>, {"sfpm", 2}).condition;
        all.insert(all.end(), one.begin(), one.end());
    }
    std::sort(all.begin(), all.end());
    return {all[all.size() / 2], all[all.size() * 99 / 100]};
}

void condition_numbers(report::Run& run, plot::Panel& panel) {
    panel.log_y().labels("$h$/d$x$", "condition number").titled("SFPM");
    std::array<std::array<Conditions, 6>, 3> found{};
    for (const Arrangement arrangement : {Arrangement::even, Arrangement::jittered, Arrangement::random}) {
        const auto a = static_cast<std::size_t>(arrangement);
        const std::string name = arrangement_names()[a];
        plot::Values h, most, median;
        for (std::size_t k = 0; k < h_over_dxs.size(); ++k) {
            const Conditions one = found[a][k] = conditions_of(run, arrangement, h_over_dxs[k]);
            median.push_back(one.median);
            run.record("sfpm " + name, 1000,
                       {{"condition_median_at_" + report::number(h_over_dxs[k], 2), one.median}});
            if (!(one.most < 1e16)) continue;  // no digit is left
            h.push_back(h_over_dxs[k]), most.push_back(one.most);
            run.record("sfpm " + name, 1000,
                       {{"condition_99_at_" + report::number(h_over_dxs[k], 2), one.most}});
        }
        panel.curve(h_over_dxs, median, {.label = name, .colour = plot::cycle(a)});
        panel.curve(h, most, {.colour = plot::cycle(a), .dash = plot::Dash::dashed});
    }
    panel.curve(
        {h_over_dxs.front(), h_over_dxs.back()},
        {Estimates<1>::largest_condition, Estimates<1>::largest_condition},
        {.label = "enlarged above", .colour = plot::Colour{0.4, 0.4, 0.4}, .dash = plot::Dash::dotted});
    constexpr std::size_t at_dx = 1, widest = 5;
    run.fill("condition-even", report::fixed(found[0][at_dx].median, 1));
    run.fill("condition-random", report::fixed(found[2][at_dx].median, 0));
    run.fill("condition-random-wide", report::fixed(found[2][widest].most, 0));
    run.claim("condition-numbers", [&] {
        bool tame = true;  // even and jittered, at every h
        for (std::size_t k = 0; k < h_over_dxs.size(); ++k)
            tame = tame && found[0][k].most < 6 && found[1][k].most < 20;
        return tame && found[2][at_dx].median > 1.5 * found[0][at_dx].median &&
               found[2][at_dx].most > Estimates<1>::largest_condition && found[2][widest].most < 1e3;
    });
}

}  // namespace

void singular(report::Run& run) {
    plot::Figure figure{"singular", 1, 3};
    condition_numbers(run, figure.at(0, 0));
    plot::Panel& share =
        figure.at(0, 1).log_y().titled("random").labels("$h$/d$x$", "share that is enlarged");
    plot::Panel& error = figure.at(0, 2)
                             .log_log()
                             .titled("random, SFPM")
                             .labels("particles $N$", "relative $L$_{2} error of the slope");
    const std::size_t sets = run.quick() ? 20 : 100;
    std::size_t left = 0, million = 0;
    double share_at_1 = 0;
    for (const char* name : {"fpm", "sfpm"}) {
        plot::Values h, flagged;
        for (const double h_over_dx : h_over_dxs) {
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
