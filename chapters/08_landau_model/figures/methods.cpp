#include <map>

#include "chapters/08_landau_model/scenes/slab.hpp"

/// What smoothing lengths and grading do to the slab: all methods, one number of particles.
namespace sph::landau {

void methods(report::Run& run) {
    const SlabScene scene{
        .n = run.quick() ? 120UL : 500UL, .times = {2, 4, 6, 8, 10}, .courant = SlabScene::fast_courant};
    plot::Figure figure{"methods"};
    plot::Panel& axes = figure.panel().labels("$t$", "relative $L$_{1} error of $s$*").log_y();
    axes.legend.outside = true;
    report::Table table{{"method", "t = 2", "4", "6", "8", "10", "energy drift", "steps", "CPU s"}};
    std::map<std::string, plot::Values> all;
    for (const SlabMethod& method : slab_methods()) {
        plot::Values errors;
        std::vector<std::string> row{method.label};
        const auto profiles = run_slab(scene, method);
        for (const SlabProfile& profile : profiles) {
            errors.push_back(profile.l1_s_star);
            row.push_back(report::number(profile.l1_s_star, 2));
            run.record(method.name + " t=" + report::number(profile.time, 3), scene.n,
                       {{"l1_s_star", profile.l1_s_star}});
        }
        const SlabProfile& last = profiles.back();
        run.record(method.name, scene.n,
                   {{"energy_drift", last.energy_drift},
                    {"steps", static_cast<double>(last.counters.steps)},
                    {"cpu_seconds", last.seconds, "s"}});
        row.push_back(report::below(last.energy_drift));
        row.push_back(std::to_string(last.counters.steps));
        row.push_back(report::timing(last.seconds));
        table.row(row);
        axes.curve(scene.times, errors, method.styled());
        all[method.name] = errors;
    }
    run.save(figure);
    run.fill("methods", table.markdown());
    run.claim(
        "without-omega",
        [&] {
            bool smaller = true;
            for (std::size_t k = 0; k < scene.times.size(); ++k) {
                const double ratio = all.at("without-omega")[k] / all.at("variable")[k];
                smaller = smaller && ratio > 0.6 && ratio < 0.82;
            }
            return smaller;
        },
        report::Needs::any_run);
}

}  // namespace sph::landau
