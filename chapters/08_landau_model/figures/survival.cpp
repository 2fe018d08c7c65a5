#include "common/report/survival.hpp"

#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"

/// Which methods finish the hard cases, on even and on disordered particles.
namespace sph::landau {
namespace {

std::vector<std::pair<std::string, TubeScene>> hard_tubes() {
    const double v = 0.99;
    return {{"problem 1", problem(1)},
            {"problem 2", problem(2)},
            {"lorentz 20", streams()},
            {"cold lorentz 5", streams(5, 1e-6, 5.0 / 3)},
            {"apart", {{1, -v, 1}, {1, v, 1}, 5.0 / 3, 0.2}},
            {"into a vacuum", {{1, 0, 1}, {0, 0, 0}, 5.0 / 3, 0.2}}};
}
constexpr std::array runs{shocks::Disorder{0, 1}, shocks::Disorder{0.1, 1}, shocks::Disorder{0.1, 2},
                          shocks::Disorder{0.3, 1}};

}  // namespace

void survival(report::Run& run) {
    const auto cases = hard_tubes();
    std::vector<std::string> names;
    for (const auto& [name, scene] : cases) names.push_back(name);
    report::Survival table{names, true, report::Judge{"chow-monaghan", 2}};
    for (const TubeMethod& method : relativistic_methods()) {
        table.contestant(method.name, method.label, runs.size(), [&](std::size_t k, std::size_t r) {
            TubeScene scene = cases[k].second;
            scene.n = run.quick() ? 30 : 40;
            scene.jitter = runs[r].jitter, scene.seed = runs[r].seed;
            scene.most_steps = 10000;
            return run_relativistic_tube(scene, method).l1_rho;
        });
    }
    table.record(run);
    run.save(table.figure("survival"));
    run.fill("survival", table.table());
    const auto none = table.all_of("none");
    run.fill("survival-none", std::to_string(none.finished) + " of " + std::to_string(none.runs));
    run.fill("survival-none-wrong", std::to_string(none.wrong()));
    run.claim("survival-none", [&] {
        for (const char* shock : {"problem 1", "lorentz 20", "cold lorentz 5"}) {
            if (table.count("none", shock).finished > 0) return false;
        }
        return table.count("none", "into a vacuum").passed == runs.size() / 2 &&
               table.count("none", "apart").passed == runs.size();
    });
    run.claim("survival-both", [&] {
        return table.all_of("reconstructed").passed == table.all_of("reconstructed").runs &&
               table.all_of("chow-monaghan").passed == table.all_of("chow-monaghan").runs;
    });
}

}  // namespace sph::landau
