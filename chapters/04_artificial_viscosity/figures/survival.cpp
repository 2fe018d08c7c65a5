#include "chapters/04_artificial_viscosity/figures/survival.hpp"

#include "chapters/04_artificial_viscosity/scenes/hard_cases.hpp"
#include "common/report/survival.hpp"

namespace sph::shocks {
namespace {

struct Attempt {
    std::size_t n;
    Disorder disorder;
};
/// The recommended method: both sizes, all disorders. The others: 200 particles only with the first seed of
/// the largest jitter. Without viscosity nothing that has a shock survives, and two runs show it.
std::vector<Attempt> attempts(const std::string& method, bool quick, bool all_runs) {
    std::vector<Attempt> runs;
    const bool best = all_runs || method == tube_methods().recommended().name, naive = method == "none";
    for (const Disorder& disorder : disorders()) {
        const bool few = disorder.jitter != 0.1 && disorder.seed == 1;
        if (few || !naive) runs.push_back({quick ? 40UL : 100UL, disorder});
        if (!quick && (best || (few && !naive && disorder.jitter > 0))) runs.push_back({200, disorder});
    }
    return runs;
}

}  // namespace

void SurvivalFigure::run(report::Run& run) const {
    std::vector<std::string> names;
    for (const HardCase& hard : hard_cases()) names.push_back(hard.name);
    report::Survival survival{names, true};
    std::vector<Method<1>> contestants = tube_contestants();
    contestants.insert(contestants.begin(), tube_methods()["none"]);
    for (const Method<1>& method : contestants) {
        const std::vector<Attempt> runs = attempts(method.name, run.quick(), all_runs_);
        survival.contestant(run, method.name, method.label, runs.size(), [&](std::size_t k, std::size_t r) {
            hard_cases()[k].run(method, runs[r].n, runs[r].disorder, run.threads());
        });
    }
    run.save(survival.figure("survival"));
    run.fill("survival", survival.table());
}

}  // namespace sph::shocks
