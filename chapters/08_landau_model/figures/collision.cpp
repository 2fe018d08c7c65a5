#include <algorithm>
#include <cmath>

#include "chapters/08_landau_model/figures/tubes.hpp"
#include "common/report/comparison.hpp"

/// Two streams that meet, and what makes the dip at their centre: one change at a time.
namespace sph::landau {
namespace {

constexpr double centre = 0.02;  // half the width of where the dip is

/// The least density near the centre over the exact one.
double dip_of(const TubeRun& run, const TubeScene& scene) {
    double least = 1e9;
    for (std::size_t i = 0; i < run.whole.x.size(); ++i) {
        if (std::abs(run.whole.x[i]) < centre) least = std::min(least, run.whole.rho[i]);
    }
    return least / relativistic_solution(scene).star().rho_right;
}
/// How far the baryons that the dip lacks push each shock out.
double pushed_out(const TubeRun& run, const TubeScene& scene) {
    const double exact = relativistic_solution(scene).star().rho_right;
    const auto& [x, rho, v, p, u] = run.whole;
    double missing = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        if (std::abs(x[i]) < centre) missing += (1 - rho[i] / exact) * (x[i + 1] - x[i - 1]) / 2;
    }
    return missing / 2;
}

struct Change {
    std::string name, label;
    TubeMethod method;
};
std::vector<Change> changes() {
    const TubeMethod& best = relativistic_methods().recommended();
    std::vector<Change> all{{"on the cubic kernel", "reconstructed, cubic spline, 1.2", best},
                            {"without conduction", "reconstructed, no conduction", best},
                            {"with much conduction", "reconstructed, α_u = 10, cap 2", best}};
    all[0].method.kernel = "cubic", all[0].method.h_over_dx = 1.2;
    all[1].method.parameters.set("alpha-u", 0);
    all[2].method.parameters.set("alpha-u", 10), all[2].method.parameters.set("cap", 2);
    return all;
}

}  // namespace

void collision(report::Run& run) {
    using shocks::Profile;
    TubeScene scene = streams();
    scene.n = 400;
    const TubeEntries all = tube_figure(run, {"collision",
                                              scene,
                                              {{"", "ρ", &Profile::rho, -0.15, 0.15},
                                               {"centre", "ρ", &Profile::rho, -centre, centre},
                                               {"centre", "$P$", &Profile::p, -centre, centre},
                                               {"right shock", "ρ", &Profile::rho, 0.085, 0.105}},
                                              false,
                                              false});
    if (run.quick()) scene.n = 100;
    using namespace report;
    Comparison table{{"method"},
                     {{"ρ at the centre, exact = 1", "centre_rho", decimals(2)},
                      {"ρ %", "l1_rho", in_percent()},
                      {"v %", "l1_v", in_percent()},
                      {"P %", "l1_p", in_percent()},
                      {"shock %", "shock_error", in_percent()}}};
    std::map<std::string, Quantities> of;
    const auto show = [&](const std::string& name, const std::string& label, const TubeEntry& entry) {
        of[name] = entry.errors() + Quantities{{"centre_rho", dip_of(entry.run, scene)}};
        table.show({label}, of[name]);
    };
    show("chow-monaghan", "Chow–Monaghan", entry_of(all, "chow-monaghan"));
    show("reconstructed", "reconstructed", entry_of(all, "reconstructed"));
    for (const Change& change : changes()) {
        const TubeRun tube = run_relativistic_tube(scene, change.method);
        show(change.name, change.label,
             {change.name, change.label, {}, scene.n, tube, shock_of(tube, scene).value_or(nowhere)});
        run.record("reconstructed " + change.name, scene.n, of[change.name]);
    }
    show("grid", "grid", entry_of(all, "grid"));
    run.fill("collision-changes", table.markdown());

    const auto value = [&](const char* name, const char* quantity) {
        return value_of(of.at(name), quantity);
    };
    const auto ratio = [&](const char* quantity) {
        return value("reconstructed", quantity) / value("chow-monaghan", quantity);
    };
    run.claim(
        "streams",
        [&] {
            return ratio("l1_rho") < 1 && ratio("l1_v") < 1 && ratio("l1_p") < 1 &&
                   ratio("shock_error") > 1.2;
        },
        report::Needs::any_run);
    run.claim("streams-dip", [&] {
        return value("reconstructed", "centre_rho") < 0.87 && value("chow-monaghan", "centre_rho") > 0.95 &&
               std::abs(value("on the cubic kernel", "centre_rho") - value("reconstructed", "centre_rho")) <
                   0.02 &&
               value("without conduction", "centre_rho") < 0.7;
    });
    run.claim("streams-cure", [&] {
        return value("with much conduction", "centre_rho") > 0.95 &&
               value("with much conduction", "l1_p") > 4 * value("reconstructed", "l1_p");
    });
    const double pushed = pushed_out(entry_of(all, "reconstructed").run, scene),
                 out = value("reconstructed", "shock_error") *
                       relativistic_solution(scene).waves().right.head.v * scene.time;
    run.fill("streams-out", report::number(out * static_cast<double>(scene.n), 2));
    run.fill("streams-pushed", report::number(pushed * static_cast<double>(scene.n), 2));
    run.claim("streams-pushed", [&] { return pushed > 0.3 * out && pushed < 0.5 * out; });
    run.claim("streams-grid", [&] {
        return value("grid", "l1_rho") < value("reconstructed", "l1_rho") &&
               value("grid", "l1_v") < value("reconstructed", "l1_v") &&
               value("grid", "l1_p") < value("reconstructed", "l1_p") &&
               entry_of(all, "grid").run.seconds < entry_of(all, "reconstructed").run.seconds / 50;
    });
}

}  // namespace sph::landau
