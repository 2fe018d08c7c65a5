#include "common/report/survival.hpp"
#include "chapters/04_artificial_viscosity/scenes/hard_cases.hpp"
#include "chapters/07_godunov_sph/figures/line.hpp"

/// Chapter 4's hard cases: the paper's scheme, and each repair.
namespace sph::godunov {

void survival(report::Run& run) {
    using shocks::hard_cases;
    std::vector<std::string> names;
    for (const shocks::HardCase& hard : hard_cases()) names.push_back(hard.name);
    struct Attempt {
        std::size_t n;
        shocks::Disorder disorder;
    };
    std::vector<Attempt> attempts;
    for (const shocks::Disorder& disorder : shocks::disorders()) {
        attempts.push_back({run.quick() ? 40UL : 100UL, disorder});
        if (!run.quick() && disorder.jitter == 0.3 && disorder.seed == 1) attempts.push_back({200, disorder});
    }
    report::Survival survival{names, true, report::Judge{"alpha-beta", 2}};
    const auto add = [&](const Method<1>& method) {
        survival.contestant(method.name, method.label, attempts.size(), [&](std::size_t k, std::size_t r) {
            return hard_cases()[k].run(method, attempts[r].n, attempts[r].disorder, run.threads());
        });
    };
    for (const Method<1>& method : one_at_a_time()) add(method);
    add(line_methods()["conducting"]);
    add(shocks::tube_methods()["alpha-beta"]);
    survival.record(run);
    run.save(survival.figure("survival"));
    run.fill("survival", survival.table());
    const auto paper = survival.all_of("inutsuka"), mine = survival.all_of("godunov");
    run.fill("survival-paper", std::to_string(paper.finished) + " of " + std::to_string(paper.runs));
    run.fill("survival-godunov", std::to_string(mine.passed) + " of " + std::to_string(mine.runs));
    run.claim("survival-paper", [&] {
        for (const char* name : {"Toro 3", "Toro 5", "Noh", "cold flows", "Mach 20 apart"}) {
            if (survival.count("inutsuka", name).finished > 0) return false;
        }
        return paper.finished < paper.runs / 2;
    });
    run.claim("survival-godunov", [&] { return mine.finished == mine.runs && mine.passed == mine.runs; });
    run.claim("survival-steps", [&] {
        for (const char* name : {"Toro 3", "Toro 4", "Toro 5", "Woodward–Colella"}) {
            if (survival.count("careful", name).passed < attempts.size()) return false;
        }
        return true;
    });
    run.claim("survival-leblanc", [&] {
        const auto passed = [&](const char* method) { return survival.count(method, "Le Blanc").passed; };
        return passed("careful") == attempts.size() && passed("own-width") == 0 &&
               passed("narrow-faces") == 0 && passed("varying-h") == attempts.size();
    });
}

}  // namespace sph::godunov
