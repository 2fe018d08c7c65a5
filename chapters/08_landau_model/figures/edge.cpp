#include <cmath>
#include <map>

#include "chapters/08_landau_model/figures/slab_profiles.hpp"
#include "common/exact/landau.hpp"
#include "common/plot/looks.hpp"

namespace sph::landau {
namespace {

constexpr double nearest = 2e-4, farthest = 1;  // from the edge, in the figure
const double edge_power = (std::sqrt(3.0) - 1) / 2;

void draw_exact(plot::Panel& panel, double t) {
    const exact::LandauSlab solution{t};
    plot::Values gap, s_star;
    for (double g = nearest; g < farthest; g *= 1.05)
        gap.push_back(g), s_star.push_back(solution.at(solution.edge() - g).s_star);
    panel.curve(gap, s_star, plot::exact());
}

void draw(plot::Panel& panel, const SlabProfile& profile, const plot::Style& look) {
    plot::Values gap, s_star;
    for (std::size_t i = profile.x.size() / 2; i < profile.x.size(); ++i) {
        const double g = 1 + profile.time - profile.x[i];
        if (g < nearest || g > farthest) continue;
        gap.push_back(g), s_star.push_back(profile.s_star[i]);
    }
    panel.points(gap, s_star, plot::dots(look, 3));
}

}  // namespace

void edge(report::Run& run) {
    const SlabScene scene{
        .n = run.quick() ? 120UL : 500UL, .times = {2, 10}, .courant = SlabScene::fast_courant};
    plot::Figure figure{"edge", 1, 2};
    for (int k = 0; k < 2; ++k) {
        const double t = scene.times[static_cast<std::size_t>(k)];
        plot::Panel& axes = figure.at(0, k).titled(at_time(t)).labels("1 + $t$ – $x$", "$s$*").log_log();
        axes.x_range(nearest, farthest).y_range(3e-3, 1).legend.shown = k == 0;
        draw_exact(axes, t);
        axes.slope(edge_power, 2e-3, 0.1, 4e-3, "power 0.366");
    }
    std::map<std::string, double> gaps;  // of the last particle, at the last time
    for (const SlabMethod& method :
         slab_methods().named({"fixed-20", "variable", "narrow", "narrow-graded"})) {
        const auto profiles = run_slab(scene, method);
        gaps[method.name] = profiles.back().edge_gap;
        run.record(method.name, scene.n, {{"edge_gap", profiles.back().edge_gap}});
        for (int k = 0; k < 2; ++k)
            draw(figure.at(0, k), profiles[static_cast<std::size_t>(k)], method.styled());
    }
    run.save(figure);
    run.fill("gap-even", report::number(gaps.at("narrow"), 2));
    run.fill("gap-graded", report::number(gaps.at("narrow-graded"), 2));
    run.claim("edge-nearer", [&] { return gaps.at("narrow-graded") < gaps.at("narrow") / 30; });
    run.claim(
        "edge-power",
        [&] {
            const exact::LandauSlab slab{scene.times.back()};
            const auto at = [&](double gap) { return slab.at(slab.edge() - gap).s_star; };
            return std::abs(std::log(at(1e-4) / at(1e-5)) / std::log(10.0) - edge_power) < 1e-3;
        },
        report::Needs::any_run);
}

}  // namespace sph::landau
