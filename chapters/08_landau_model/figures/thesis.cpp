#include <map>

#include "chapters/08_landau_model/figures/slab_profiles.hpp"
#include "common/exact/landau.hpp"
#include "common/plot/looks.hpp"

/// The slab as the thesis resolves it (Chen 2017, figure 25): even particles, one h for all and for ever.
namespace sph::landau {

void thesis(report::Run& run) {
    const SlabScene scene{
        .n = run.quick() ? 200UL : 1000UL, .times = {2, 4, 6, 8, 10}, .courant = SlabScene::fast_courant};
    plot::Figure figure{"thesis", 1, 2};
    figure.share_y = true;
    std::map<std::string, plot::Values> errors;
    int column = 0;
    for (const SlabMethod& method : slab_methods().named({"fixed-20", "fixed-4"})) {
        plot::Panel& panel =
            figure.at(0, column).titled(method.label).labels("$x$", column == 0 ? "$s$*" : "");
        panel.x_range(0, 11.5).y_range(0, 0.75);
        panel.legend.shown = column++ == 0;
        std::size_t k = 0;
        for (const SlabProfile& profile : run_slab(scene, method)) {
            draw_right_half(panel, profile, profile.s_star, k++);
            errors[method.name].push_back(profile.l1_s_star);
            run.record(method.name + " t=" + report::number(profile.time, 3), scene.n,
                       {{"l1_s_star", profile.l1_s_star}, {"energy_drift", profile.energy_drift}});
        }
        for (const double t : scene.times) {
            plot::Style exact = plot::exact();
            if (t > scene.times.front()) exact.label.clear();
            const exact::LandauSlab solution{t};
            plot::draw_exact(
                panel, 0, solution.edge(), [&](double x) { return solution.at(x).s_star; }, exact);
        }
    }
    run.save(figure);
    run.fill("thesis-20", report::percent(errors.at("fixed-20").back()));
    run.fill("thesis-4", report::number(100 * errors.at("fixed-4").back(), 2));
    run.claim("thesis-works", [&] { return errors.at("fixed-20").back() < 0.015; });
    run.claim("thesis-h", [&] { return errors.at("fixed-4").back() > 0.4; });
}

}  // namespace sph::landau
