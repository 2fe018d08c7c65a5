#include "chapters/08_landau_model/figures/figures.hpp"
#include "common/core/unstable.hpp"

/// Which methods finish the hard cases, on even and on disordered particles.
namespace sph::landau {
namespace {

struct HardCase {
    std::string name;
    TubeScene scene;
};
std::vector<HardCase> hard_cases() {
    const double v = 0.99;
    return {{"problem 1", problem(1)},
            {"problem 2", problem(2)},
            {"lorentz 20", streams()},
            {"cold lorentz 5", streams(5, 1e-6, 5.0 / 3)},
            {"apart", {{1, -v, 1}, {1, v, 1}, 5.0 / 3, 0.2}},
            {"into a vacuum", {{1, 0, 1}, {0, 0, 0}, 5.0 / 3, 0.2}}};
}
struct Disorder {
    double jitter;
    unsigned long seed;
};
constexpr std::array disorders{Disorder{0, 1}, Disorder{0.1, 1}, Disorder{0.1, 2}, Disorder{0.3, 1}};

bool finishes(TubeScene scene, const Method& method, const Disorder& disorder, std::size_t n) {
    scene.n = n, scene.jitter = disorder.jitter, scene.seed = disorder.seed;
    scene.most_steps = 10000;
    try {
        run_relativistic_tube(scene, method);
        return true;
    } catch (const Unstable&) {
        return false;
    }
}

}  // namespace

void survival(report::Run& run) {
    const std::size_t n = run.quick() ? 30 : 40;
    std::vector<std::string> header{"runs finished"};
    for (const HardCase& hard : hard_cases()) header.push_back(hard.name);
    report::Table table{header};
    plot::Figure figure{"survival"};
    plot::Panel& panel = figure.panel().labels("runs finished [%]", "").x_range(0, 105);
    panel.grid = false;
    double y = 0;
    for (const Method& method : relativistic_methods()) {
        std::vector<std::string> row{method.label};
        double all = 0, possible = 0;
        for (const HardCase& hard : hard_cases()) {
            int finished = 0;
            for (const Disorder& disorder : disorders)
                finished += finishes(hard.scene, method, disorder, n) ? 1 : 0;
            run.result(method.name + " " + hard.name, static_cast<long>(disorders.size()), "finished",
                       finished, "runs");
            row.push_back(std::to_string(finished) + "/" + std::to_string(disorders.size()));
            all += finished, possible += static_cast<double>(disorders.size());
        }
        table.row(row);
        y += 1;
        panel.y.ticks.push_back(-y);
        panel.y.tick_names.push_back(method.label);
        panel.band({0, 100 * all / possible}, {-y - 0.3, -y - 0.3}, {-y + 0.3, -y + 0.3}).colour =
            plot::cycle(0);
    }
    run.save(figure);
    run.fill("survival", table.markdown());
}

}  // namespace sph::landau
