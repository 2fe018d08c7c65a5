#include <algorithm>
#include <map>

#include "chapters/08_landau_model/scenes/slab.hpp"

/// What smoothing lengths and grading do to the slab: all methods, one number of particles.
namespace sph::landau {
namespace {

using Errors = std::map<std::string, plot::Values>;  // of a method, at each time

void draw(report::Run& run, const std::vector<double>& times, const Errors& errors) {
    plot::Figure figure{"methods", 1, 2};
    const auto panel = [&](int column, const std::string& title, const std::vector<std::string>& names) {
        plot::Panel& axes =
            figure.at(0, column).titled(title).labels("$t$", "relative $L$_{1} error of $s$*");
        axes.log_y().y_range(2e-4, column == 0 ? 2 : 0.1);
        for (const SlabMethod& method : slab_methods().named(names))
            axes.curve(times, errors.at(method.name), method.styled());
    };
    panel(0, "one $h$ for all, or of each its own", {"fixed-4", "fixed-10", "fixed-20", "variable"});
    panel(1, "of each its own $h$", {"variable", "without-omega", "graded", "narrow", "narrow-graded"});
    run.save(figure);
}

void assert_text(report::Run& run, const Errors& errors) {
    run.claim("fixed-fails", [&] {
        const plot::Values &four = errors.at("fixed-4"), &twenty = errors.at("fixed-20");
        const auto [least, most] = std::minmax_element(twenty.begin(), twenty.end());
        return std::is_sorted(four.begin(), four.end()) && four.back() > 0.5 && *least > 0.02 &&
               *most < 0.035;
    });
    const auto gain = [&](const char* from, const char* to) {
        return errors.at(from).back() / errors.at(to).back();
    };
    run.fill("gain-graded", report::number(gain("variable", "graded"), 2));
    run.fill("gain-narrow", report::number(gain("variable", "narrow"), 2));
    run.fill("gain-both", report::number(gain("variable", "narrow-graded"), 2));
    run.claim("both-causes", [&] {
        return gain("variable", "graded") < 3 && gain("variable", "narrow") < 3 &&
               gain("variable", "narrow-graded") > 10;
    });
    run.claim(
        "without-omega",
        [&] {
            for (std::size_t k = 0; k < errors.at("variable").size(); ++k) {
                const double ratio = errors.at("without-omega")[k] / errors.at("variable")[k];
                if (!(ratio > 0.6 && ratio < 0.82)) return false;
            }
            return true;
        },
        report::Needs::any_run);
}

}  // namespace

void methods(report::Run& run) {
    const SlabScene scene{
        .n = run.quick() ? 120UL : 500UL, .times = {2, 4, 6, 8, 10}, .courant = SlabScene::fast_courant};
    report::Table table{{"method", "t = 2", "4", "6", "8", "10", "energy drift", "steps", "CPU s"}};
    report::Table story{{"method", "masses", "error at t = 2", "at t = 10", "energy drift"}};
    Errors errors;
    for (const SlabMethod& method : slab_methods()) {
        std::vector<std::string> row{method.label};
        const auto profiles = run_slab(scene, method);
        for (const SlabProfile& profile : profiles) {
            errors[method.name].push_back(profile.l1_s_star);
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
        story.row({method.label, method.graded ? "graded" : "equal", row[1], row[5], row[6]});
    }
    draw(run, scene.times, errors);
    run.fill("methods", table.markdown());
    run.fill("methods-story", story.markdown());
    assert_text(run, errors);
}

}  // namespace sph::landau
