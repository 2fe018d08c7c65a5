#include <cmath>
#include <map>

#include "chapters/08_landau_model/scenes/slab.hpp"

/// What the time step does to the energy, and what the terms of a varying h are for.
namespace sph::landau {

void drift(report::Run& run) {
    const std::vector<double> courants =
        run.quick() ? std::vector<double>{0.3, 0.6} : std::vector<double>{0.08, 0.15, 0.3, 0.6};
    plot::Figure figure{"drift"};
    plot::Panel& axes =
        figure.panel().log_log().labels("step over crossing time", "relative energy drift, $t$ = 2");
    report::Table table{{"method", "courant", "energy drift", "relative L1 of s*", "steps"}};
    double lowest = 0;
    std::map<std::string, plot::Values> all;
    for (const SlabMethod& method :
         slab_methods().named({"fixed-20", "without-omega", "variable", "narrow-graded"})) {
        plot::Values drifts;
        for (const double courant : courants) {
            const SlabScene scene{.n = 250, .times = {2}, .courant = courant};
            const SlabProfile profile = run_slab(scene, method).back();
            drifts.push_back(std::abs(profile.energy_drift));
            run.record(method.name + " courant=" + report::number(courant, 2), 250,
                       {{"energy_drift", profile.energy_drift}});
            table.row({method.label, report::number(courant, 2), report::below(drifts.back()),
                       report::number(profile.l1_s_star, 3), std::to_string(profile.counters.steps)});
        }
        lowest = drifts.front();
        all[method.name] = drifts;
        axes.curve(courants, drifts, method.styled());
    }
    axes.slope(5, 0.1, 0.3, 3e-8, "power 5");
    axes.slope(2, 0.15, 0.5, 5e-9, "power 2");
    axes.y_range(1e-11, 1e-3);
    run.save(figure);
    run.fill("answer-drift", report::below(lowest));
    run.fill("drift", table.markdown());
    run.claim("drift-powers", [&] {
        const auto power = [&](const char* method) {
            const plot::Values& of = all.at(method);
            return std::log(of.back() / of.front()) / std::log(courants.back() / courants.front());
        };
        return power("variable") > 4.3 && power("variable") < 5.2 && power("fixed-20") > 1.5 &&
               power("fixed-20") < 2.5 && all.at("fixed-20").back() < all.at("variable").back() / 100;
    });
    run.claim("drift-narrow", [&] {
        const plot::Values &narrow = all.at("narrow-graded"), &wide = all.at("variable");
        for (std::size_t k = 0; k < narrow.size(); ++k) {
            if (!(narrow[k] < wide[k] / 3)) return false;
        }
        return true;
    });
    run.claim("drift-omega",
              [&] { return all.at("without-omega").front() > all.at("without-omega").back() / 2; });
}

}  // namespace sph::landau
