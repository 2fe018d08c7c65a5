#include <map>

#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {

/// What each of them costs in accuracy, one change at a time.
void methods(report::Run& run) {
    const Flow flow = cylinder(10, 1, 1.0 / 3);
    const std::vector<double> times{2, 5, 10, 15};
    const std::size_t n = run.quick() ? 300 : 10000;
    plot::Figure figure{"methods"};
    plot::Panel& axes = figure.panel().labels("τ", "relative $L$_{1} error of $T$, $r$ < $R$").log_y();
    axes.legend.outside = true;
    report::Table table{{"particles and force", "L1 of T %: τ = 5", "10", "15", "axis %, 10", "axis %, 15"}};
    std::map<std::string, Snapshot> last, middle;
    for (const PlaneMethod& method : plane_methods()) {
        const auto shots = run_plane(flow, {.n = n, .times = times}, method);
        plot::Values error;
        for (const Snapshot& shot : shots) {
            error.push_back(shot.l1_temperature);
            run.record(method.name + " tau=" + report::number(shot.time, 2), shot.x.size(), shot.measured());
        }
        if (method.name != "spiral" && method.name != "rings") axes.curve(times, error, method.styled());
        if (method.name != "relaxed")
            table.row({method.label, report::percent(error[1]), report::percent(error[2]),
                       report::percent(error[3]), report::percent(shots[2].axis),
                       report::percent(shots[3].axis)});
        last[method.name] = shots[3], middle[method.name] = shots[2];
    }
    run.save(figure);
    run.fill("methods", table.markdown());
    const auto l1 = [&](const char* name) { return last.at(name).l1_temperature; };
    run.fill("relaxed-error", report::percent(l1("relaxed")));
    run.fill("corrected-momentum", report::number(last.at("corrected").momentum, 1));
    run.claim("grading-helps", [&] { return l1("spiral-graded") < 0.75 * l1("spiral-solved"); });
    run.claim("omega-costs", [&] { return last.at("spiral-graded").axis < 0.5 * last.at("grad-h").axis; });
    run.claim("fixed-loses", [&] { return l1("fixed-h") > 2 * l1("spiral-graded"); });
    run.claim("corrected-worse", [&] {
        return l1("corrected") > 2 * l1("spiral-graded") && last.at("corrected").momentum > 1e-9;
    });
    run.claim("ring-lattice-noise",
              [&] { return middle.at("rings").axis > 10 * middle.at("hexagonal").axis; });
    run.claim("relaxed-noisy", [&] { return l1("relaxed") > 2 * l1("hexagonal"); });
}

}  // namespace sph::transverse
