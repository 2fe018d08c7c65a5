#include "chapters/04_artificial_viscosity/scenes/hard_cases.hpp"

#include <stdexcept>

#include "chapters/04_artificial_viscosity/scenes/woodward_colella.hpp"

namespace sph::shocks {
namespace {

constexpr long most_steps = 6000;

HardCase tube(const std::string& name, TubeScene scene) {
    scene.most_steps = most_steps;
    return {name, [scene](const Method<1>& method, std::size_t n, const Disorder& disorder, int threads) {
                TubeScene one = scene;
                one.n = n, one.jitter = disorder.jitter, one.seed = disorder.seed, one.threads = threads;
                return run_tube(one, method).l1_rho;
            }};
}

double blast_waves(const Method<1>& method, std::size_t n, const Disorder& disorder, int threads) {
    return run_blast_waves({.n = n,
                            .jitter = disorder.jitter,
                            .seed = disorder.seed,
                            .threads = threads,
                            .most_steps = most_steps},
                           method)
        .l1_rho;
}

}  // namespace

const std::vector<Disorder>& disorders() {
    static const std::vector<Disorder> all{{0, 1}, {0.1, 1}, {0.1, 2}, {0.3, 1}, {0.3, 2}};
    return all;
}

const std::vector<HardCase>& hard_cases() {
    static const std::vector<HardCase> cases{
        tube("Toro 1", {{1, 0.75, 1}, {0.125, 0, 0.1}, 1.4, 0.2}),
        tube("Toro 2 (123)", {{1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.15}),
        tube("Toro 3", {{1, 0, 1000}, {1, 0, 0.01}, 1.4, 0.004}),
        tube("Toro 4", {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1.4, 0.01}),
        tube("Toro 5", {{1, -19.59745, 1000}, {1, -19.59745, 0.01}, 1.4, 0.004}),
        tube("vacuum", {{1, 0, 1}, {0, 0, 0}, 1.4, 0.1}),
        tube("Mach 20 apart", {{1, -20, 1 / 1.4}, {1, 20, 1 / 1.4}, 1.4, 0.02}),
        tube("Noh", {{1, 1, 1e-6}, {1, -1, 1e-6}, 5.0 / 3, 0.1}),
        tube("cold flows", {{1, 1, 1e-8 / 1.4}, {1, -1, 1e-8 / 1.4}, 1.4, 0.1}),
        tube("blast", {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.003}),
        tube("Le Blanc", {{1, 0, 0.2 / 3}, {1e-3, 0, 0.2e-9 / 3}, 5.0 / 3, 0.5}),
        {"Woodward–Colella", blast_waves}};
    return cases;
}

const HardCase& hard_case(const std::string& name) {
    for (const HardCase& hard : hard_cases()) {
        if (hard.name == name) return hard;
    }
    throw std::invalid_argument{"no such hard case: " + name};
}

}  // namespace sph::shocks
