#include <cmath>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/scenes/slab.hpp"
#include "common/exact/landau.hpp"
#include "common/plot/looks.hpp"

namespace sph::landau {
namespace {

void draw(report::Run& run, const SlabProfile& profile) {
    const exact::LandauSlab solution{profile.time};
    constexpr int points = 201;
    plot::Values x, s_star, eps, rapidity;
    for (int k = 0; k < points; ++k) {
        x.push_back(solution.edge() * (2.0 * k / (points - 1) - 1) * (1 - 1e-9));
        const auto at = solution.at(x.back());
        s_star.push_back(at.s_star), eps.push_back(at.eps), rapidity.push_back(at.rapidity);
    }
    plot::Figure figure{"slab-scene", 2, 2};
    const auto panel = [&](int row, int column, const std::string& label, const Column& value,
                           const plot::Values& exact) -> plot::Panel& {
        return plot::beside_exact(figure.at(row, column).labels("$x$", label), x, exact, profile.x, value);
    };
    panel(0, 0, "$s$*", profile.s_star, s_star);
    panel(0, 1, "rapidity", profile.rapidity, rapidity);
    panel(1, 0, "$s$*", profile.s_star, s_star).log_y();
    panel(1, 1, "ε", profile.eps, eps).log_y();
    run.save(figure);
}

Column velocities(const Column& rapidity) {
    Column v;
    for (const double y : rapidity) v.push_back(std::tanh(y));
    return v;
}

}  // namespace

SlabCommand::SlabCommand() : method_{slab_methods(), any_kernel_names(), {0.5, 100}, least_h_over_dx} {}

void SlabCommand::declare(app::CommandLine& line) {
    line.integer("particles", particles_, 10, 1000000, "in |x| <= 1")
        .number("time", time_, {0, exact::LandauSlab::largest_time, true}, "time", "how long the scene runs")
        .number("courant", courant_, {0, 1, true}, "",
                "step over the shortest time in which sound crosses an h");
    method_.declare(line);
}

void SlabCommand::run(report::Run& run) const {
    if (method_.wants_list()) return run.print(slab_methods().text());
    const SlabMethod method = method_.chosen();
    report::tell(run, method);
    const SlabScene scene{.n = static_cast<std::size_t>(particles_),
                          .times = {time_},
                          .courant = courant_,
                          .threads = run.threads(),
                          .progress = run.progress()};
    const SlabProfile profile = run_slab(scene, method).back();
    run.record(method.name, scene.n,
               {{"l1_s_star", profile.l1_s_star},
                {"energy_drift", profile.energy_drift},
                {"momentum_drift", profile.momentum},
                {"edge_gap", profile.edge_gap},
                {"steps", static_cast<double>(profile.counters.steps)},
                {"pairs", static_cast<double>(profile.counters.pairs)},
                {"cpu_seconds", profile.seconds, "s"}});
    const Column v = velocities(profile.rapidity), exact_v = velocities(profile.exact_rapidity);
    run.write("profile.csv", report::csv({{"x", profile.x},
                                          {"s_star", profile.s_star},
                                          {"exact_s_star", profile.exact_s_star},
                                          {"eps", profile.eps},
                                          {"exact_eps", profile.exact_eps},
                                          {"rapidity", profile.rapidity},
                                          {"exact_rapidity", profile.exact_rapidity},
                                          {"v", v},
                                          {"exact_v", exact_v}}));
    draw(run, profile);
}

}  // namespace sph::landau
