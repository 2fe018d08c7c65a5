#include <algorithm>
#include <cmath>
#include <map>

#include "chapters/09_transverse_expansion/scenes/line.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

/// The cylinder as rings in (tau, r): the gradient of sqrt(-g) at work, and what the axis does to it.
namespace sph::transverse {
namespace {

using Counts = std::vector<std::size_t>;

plot::Style few_rings(std::size_t n) {
    return {.label = std::to_string(n) + " rings", .colour = plot::cycle(0), .marker = plot::Marker::square};
}
plot::Style many_rings(std::size_t n) {
    return {.label = std::to_string(n) + " rings", .colour = plot::cycle(1), .marker = plot::Marker::circle};
}

/// True if rings with images of negative entropy do not come to tau = 2.
bool negative_images_fail(std::size_t n) {
    try {
        run_line({.n = n, .times = {2}, .share = -1});
    } catch (const Unstable&) {
        return true;
    }
    return false;
}

plot::Values ring_errors(const LineProfile& profile) {
    plot::Values off;
    for (std::size_t i = 0; i < profile.r.size(); ++i)
        off.push_back(std::abs(profile.temperature[i] / profile.exact_temperature[i] - 1));
    return off;
}

/// Every fifth ring within R, beside the exact line.
void draw_rings(plot::Panel& panel, const LineProfile& profile, const exact::TransverseProfile& solution,
                plot::Style look, bool labelled) {
    plot::draw_exact(
        panel, 0, 10, [&](double r) { return solution.at(r).temperature; },
        plot::exact(labelled ? "exact" : ""));
    if (!labelled) look.label.clear();
    plot::Values r, T;
    for (std::size_t i = 2; i < profile.r.size() && profile.r[i] < 10; i += 5)
        r.push_back(profile.r[i]), T.push_back(profile.temperature[i]);
    panel.points(r, T, look);
}

}  // namespace

void rings(report::Run& run) {
    const Counts counts = run.quick() ? Counts{50, 100} : Counts{100, 200, 400};
    const std::vector<double> times =
        run.quick() ? std::vector<double>{5, 10} : std::vector<double>{5, 10, 15, 20};
    const auto solutions = exact_lines({}, times);
    std::map<std::size_t, std::vector<LineProfile>> all;
    for (const std::size_t n : counts) {
        all[n] = run_line({.n = n}, solutions);
        for (const LineProfile& profile : all[n])
            run.record("rings tau=" + report::number(profile.time, 2), n, profile.measured());
    }
    const auto &coarse = all.at(counts.front()), &fine = all.at(counts.back());
    plot::Figure figure{"rings", 1, 2};
    plot::Panel& left = figure.at(0, 0).labels("$r$", "$T$/$T$_{0}").x_range(0, 10);
    for (std::size_t k = 0; k < fine.size(); ++k)
        draw_rings(left, fine[k], solutions[k], plot::dots(many_rings(counts.back()), 3), k == 0);
    plot::Panel& right = figure.at(0, 1).titled("τ = 10").labels("$r$", "|$T$/$T$_{exact} – 1|").log_y();
    right.x_range(0, 10).y_range(1e-5, 0.5);
    right.points(coarse[1].r, ring_errors(coarse[1]), plot::dots(few_rings(counts.front()), 3.5));
    right.points(fine[1].r, ring_errors(fine[1]), plot::dots(many_rings(counts.back()), 3));
    run.save(figure);

    double worst = 0;
    for (const LineProfile& profile : fine) worst = std::max(worst, profile.l1_temperature);
    const double order = report::observed_order(static_cast<double>(counts.front()), coarse[1].l1_temperature,
                                                static_cast<double>(counts.back()), fine[1].l1_temperature);
    const double unpaired = unpaired_force(100, false);
    run.fill("rings-l1", report::number(100 * worst, 2));
    run.fill("rings-order", report::number(order, 2));
    run.fill("rings-axis-few", report::number(100 * coarse[1].axis, 2));
    run.fill("rings-axis-many", report::number(100 * fine[1].axis, 2));
    run.fill("rings-inside", report::number(100 * fine[1].inside, 2));
    run.fill("unpaired-force", report::number(100 * unpaired, 2));
    run.claim("rings-converge", [&] { return worst < 2.5e-3 && order > 0.8; });
    run.claim("rings-axis", [&] { return coarse[1].axis > 0.05 && fine[1].axis > coarse[1].axis / 2; });
    run.claim("rings-noise", [&] { return fine[1].inside > 0.01 && fine[1].inside < coarse[1].inside / 2; });
    run.claim("negative-images", [&] { return negative_images_fail(100) && negative_images_fail(400); });
    run.claim("unpaired", [&] {
        return unpaired_force(100, true) < 1e-14 && unpaired > 1e-3 &&
               unpaired_force(400, false) < unpaired / 3;
    });
}

}  // namespace sph::transverse
