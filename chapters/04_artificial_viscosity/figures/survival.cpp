#include "chapters/04_artificial_viscosity/figures/survival.hpp"

#include "chapters/04_artificial_viscosity/scenes/hard_cases.hpp"
#include "common/report/survival.hpp"

namespace sph::shocks {
namespace {

struct Attempt {
    std::size_t n;
    Disorder disorder;
};
/// The same for every method, so that its rows compare: the smaller size with all disorders, the larger one
/// with the first seed of the largest jitter; with all of them on request.
std::vector<Attempt> attempts(bool quick, bool all_runs) {
    std::vector<Attempt> runs;
    for (const Disorder& disorder : disorders()) {
        runs.push_back({quick ? 40UL : 100UL, disorder});
        if (!quick && (all_runs || (disorder.jitter == 0.3 && disorder.seed == 1)))
            runs.push_back({200, disorder});
    }
    return runs;
}

/// What the text says of the table.
void assert_text(report::Run& run, const report::Survival& survival) {
    const report::Survival::Count naive = survival.all_of("none");
    run.fill("survival-none", std::to_string(naive.finished) + " of " + std::to_string(naive.runs));
    run.fill("survival-none-wrong", std::to_string(naive.wrong()));
    run.claim("survival-none", [&] {
        const auto passed = [&](const char* name) { return survival.count("none", name).passed; };
        const auto runs = naive.runs / hard_cases().size();
        for (const char* shock :
             {"Toro 1", "Toro 3", "Toro 4", "Toro 5", "Noh", "cold flows", "blast", "Woodward–Colella"}) {
            if (passed(shock) > 0) return false;
        }
        return passed("Toro 2 (123)") == runs && passed("Mach 20 apart") == runs && passed("vacuum") > 0 &&
               passed("vacuum") < runs && passed("Le Blanc") > 0 && passed("Le Blanc") < runs;
    });
    run.claim("survival-viscosity", [&] {
        for (const Method<1>& method : tube_contestants()) {
            const report::Survival::Count all = survival.all_of(method.name);
            const bool pressures = method.name == "von-neumann" || method.name == "bulk";
            const bool conducts = method.name == "thermokinetic" || method.name == "price";
            if (pressures == (all.finished == all.runs)) return false;
            if (!pressures && !conducts && all.passed < all.runs) return false;
        }
        return true;
    });
    run.claim("survival-conduction", [&] {
        const auto wrong = [&](const char* method, const char* hard) {
            return survival.count(method, hard).wrong();
        };
        const auto waves = survival.count("price", "Woodward–Colella");
        return waves.finished == waves.runs && waves.passed <= 1 &&
               survival.all_of("price").wrong() == waves.wrong() &&
               survival.all_of("thermokinetic").wrong() == wrong("thermokinetic", "Woodward–Colella") &&
               wrong("thermokinetic", "Woodward–Colella") < waves.wrong();
    });
}

}  // namespace

void SurvivalFigure::run(report::Run& run) const {
    std::vector<std::string> names;
    for (const HardCase& hard : hard_cases()) names.push_back(hard.name);
    const std::vector<Attempt> runs = attempts(run.quick(), all_runs_);
    report::Survival survival{names, true, report::Judge{"alpha-beta", 2}};
    std::vector<Method<1>> contestants = tube_contestants();
    contestants.insert(contestants.begin(), tube_methods()["none"]);
    for (const Method<1>& method : contestants) {
        survival.contestant(method.name, method.label, runs.size(), [&](std::size_t k, std::size_t r) {
            return hard_cases()[k].run(method, runs[r].n, runs[r].disorder, run.threads());
        });
    }
    survival.record(run);
    run.save(survival.figure("survival"));
    run.fill("survival", survival.table());
    assert_text(run, survival);
}

}  // namespace sph::shocks
