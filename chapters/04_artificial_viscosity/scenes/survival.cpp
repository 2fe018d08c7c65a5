#include "chapters/04_artificial_viscosity/scenes/survival.hpp"

#include "chapters/04_artificial_viscosity/scenes/woodward_colella.hpp"
#include "common/core/unstable.hpp"

namespace sph {

const std::vector<HardCase>& hard_cases() {
    static const std::vector<HardCase> cases{
        {"Toro 1", {{1, 0.75, 1}, {0.125, 0, 0.1}, 1.4, 0.2}},
        {"Toro 2 (123)", {{1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.15}},
        {"Toro 3", {{1, 0, 1000}, {1, 0, 0.01}, 1.4, 0.004}},
        {"Toro 4", {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1.4, 0.01}},
        {"Toro 5", {{1, -19.59745, 1000}, {1, -19.59745, 0.01}, 1.4, 0.004}},
        {"vacuum", {{1, 0, 1}, {0, 0, 0}, 1.4, 0.1}},
        {"Mach 20 apart", {{1, -20, 1 / 1.4}, {1, 20, 1 / 1.4}, 1.4, 0.02}},
        {"Noh", {{1, 1, 1e-6}, {1, -1, 1e-6}, 5.0 / 3, 0.1}},
        {"cold flows", {{1, 1, 1e-8 / 1.4}, {1, -1, 1e-8 / 1.4}, 1.4, 0.1}},
        {"blast", {{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.003}},
        {"Le Blanc", {{1, 0, 0.2 / 3}, {1e-3, 0, 0.2e-9 / 3}, 5.0 / 3, 0.5}},
        {"Woodward–Colella", {}, true},
    };
    return cases;
}

const std::vector<Disorder>& disorders() {
    static const std::vector<Disorder> all{{0, 1}, {0.1, 1}, {0.1, 2}, {0.3, 1}, {0.3, 2}};
    return all;
}

std::string survive(const HardCase& hard, const Method& method, std::size_t n, const Disorder& disorder,
                    int threads) {
    try {
        if (hard.blast_waves) {
            run_blast_waves({.n = n, .jitter = disorder.jitter, .seed = disorder.seed, .threads = threads},
                            method);
            return "";
        }
        TubeScene scene = hard.scene;
        scene.n = n;
        scene.jitter = disorder.jitter;
        scene.seed = disorder.seed;
        scene.threads = threads;
        scene.most_steps = 6000;
        run_tube(scene, method);
        return "";
    } catch (const Unstable& failure) {
        return failure.what();
    }
}

}  // namespace sph
