#include "chapters/05_tensile_instability/scenes/held_box.hpp"

#include <algorithm>

#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"

namespace sph::tensile {
namespace {

using BoxLiquid = CuredLiquid<FixedH<AnyKernel<2>>, Free>;

/// The free particles first, then the fixed ones, which are one group.
Columns<2> places(const HeldBox& scene) {
    Columns<2> free, fixed;
    const double low = static_cast<double>(scene.layers), high = low + static_cast<double>(scene.free_side);
    for (std::size_t i = 0; i < scene.side() * scene.side(); ++i) {
        const double x = static_cast<double>(i % scene.side()) + 0.5,
                     y = static_cast<double>(i / scene.side()) + 0.5;
        Columns<2>& to = std::min(x, y) > low && std::max(x, y) < high ? free : fixed;
        to[0].push_back(x), to[1].push_back(y);
    }
    for (std::size_t a = 0; a < 2; ++a) free[a].insert(free[a].end(), fixed[a].begin(), fixed[a].end());
    return free;
}

Columns<2> range(const Columns<2>& x, std::size_t begin, std::size_t end) {
    Columns<2> part;
    for (std::size_t a = 0; a < 2; ++a)
        part[a].assign(x[a].begin() + std::ptrdiff_t(begin), x[a].begin() + std::ptrdiff_t(end));
    return part;
}

Column distances(const Columns<2>& a, const Columns<2>& b, std::size_t n) {
    Column moved(n);
    for (std::size_t i = 0; i < n; ++i) moved[i] = std::hypot(a[0][i] - b[0][i], a[1][i] - b[1][i]);
    return moved;
}

double smallest_distance(const Columns<2>& x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            nearest = std::min(nearest, std::hypot(x[0][i] - x[0][j], x[1][i] - x[1][j]));
    }
    return nearest;
}

}  // namespace

HeldBoxRun run_held_box(const HeldBox& scene) {
    constexpr double clumped = 0.5;
    const std::size_t n = scene.side() * scene.side(), free = scene.free_side * scene.free_side;
    const Liquid state{scene.pressure, 1, named_lattice<2>(scene.kernel, scene.h_over_dx).density};
    const Columns<2> at = places(scene);
    BoxLiquid liquid{n, {scene.h_over_dx, AnyKernel<2>{scene.kernel}}, state, Free{}, scene.threads};
    for (std::size_t i = 0; i < n; ++i)
        liquid.place(i, {at[0][i], at[1][i]}, {0, 0}, 1, state.rho_0, state.P);
    const std::size_t middle = free / 2 + scene.free_side / 2;
    liquid.particles.v[0][middle] = scene.push;
    liquid.groups().hold("wall", free, n);
    liquid.start(0);
    liquid.limit_steps([dt = scene.courant] { return dt; });
    HeldBoxRun run;
    run.fixed = range(at, free, n);
    double t = 0;
    march(liquid, t, {.end = scene.time}, [&](double now) {
        const Column moved = distances(liquid.particles.x, at, free);
        run.t.push_back(now);
        run.farthest.push_back(*std::max_element(moved.begin(), moved.end()));
        if (run.clumped_at == 0 && run.farthest.back() > clumped) run.clumped_at = now;
        if (now < scene.shown || !run.moved.empty()) return;
        run.shown = range(liquid.particles.x, 0, free);
        run.moved = moved;
        run.nearest = smallest_distance(run.shown);
    });
    return run;
}

}  // namespace sph::tensile
