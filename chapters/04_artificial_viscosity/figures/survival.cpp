#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "chapters/04_artificial_viscosity/scenes/survival.hpp"

namespace sph::shocks {

namespace {

struct Run {
    std::size_t n;
    Disorder disorder;
};
/// The recommended method: both sizes, all disorders. The others: 200 particles only with the first seed of
/// the largest jitter. Without viscosity nothing that has a shock survives, and two runs show it.
std::vector<Run> runs_of(const std::string& method, bool quick, bool all_runs) {
    std::vector<Run> runs;
    const bool best = all_runs || method == best_tube_method().name, naive = method == "none";
    for (const Disorder& disorder : disorders()) {
        const bool few = disorder.jitter != 0.1 && disorder.seed == 1;
        if (few || !naive) runs.push_back({quick ? 40UL : 100UL, disorder});
        if (!quick && (best || (few && !naive && disorder.jitter > 0))) runs.push_back({200, disorder});
    }
    return runs;
}

}  // namespace

void survival(report::Run& run, bool all_runs) {
    std::vector<std::string> header{"runs finished"};
    for (const HardCase& hard : hard_cases()) header.push_back(hard.name);
    header.emplace_back("all");
    report::Table table{header};
    plot::Figure figure{"survival"};
    plot::Panel& panel = figure.panel().labels("runs finished [%]", "").x_range(0, 105);
    panel.grid = false;
    double y = 0;
    for (const Method& method : tube_methods()) {
        const std::vector<Run> runs = runs_of(method.name, run.quick(), all_runs);
        const auto each = static_cast<long>(runs.size());
        std::vector<std::string> row{method.label};
        long all = 0;
        for (const HardCase& hard : hard_cases()) {
            long finished = 0;
            for (const Run& one : runs)
                finished += survive(hard, method, one.n, one.disorder, run.threads()).empty() ? 1 : 0;
            all += finished;
            run.result(method.name + " " + hard.name, each, "finished", static_cast<double>(finished),
                       "runs");
            row.push_back(std::to_string(finished) + "/" + std::to_string(each));
        }
        const long possible = each * static_cast<long>(hard_cases().size());
        row.push_back(std::to_string(all) + "/" + std::to_string(possible));
        table.row(row);
        run.result(method.name + " all", possible, "finished", static_cast<double>(all), "runs");
        y += 1;
        panel.y.ticks.push_back(-y);
        panel.y.tick_names.push_back(method.label);
        panel
            .band({0, 100.0 * static_cast<double>(all) / static_cast<double>(possible)}, {-y - 0.3, -y - 0.3},
                  {-y + 0.3, -y + 0.3})
            .colour = plot::cycle(0);
    }
    run.save(figure);
    run.fill("survival", table.markdown());
}

}  // namespace sph::shocks
