#include <algorithm>
#include <cmath>

#include "chapters/08_landau_model/figures/tubes.hpp"

namespace sph::landau {
namespace {

/// The least and the largest density over the exact one in the middle of the shell.
std::array<double, 2> shell_densities(const TubeRun& run, const TubeScene& scene) {
    constexpr double margin = 0.15;  // of its width, on either side
    const auto solution = relativistic_solution(scene);
    const double inner = solution.waves().contact.v * scene.time,
                 outer = solution.waves().right.head.v * scene.time, cut = margin * (outer - inner);
    std::array<double, 2> bounds{10, 0};
    for (std::size_t i = 0; i < run.whole.x.size(); ++i) {
        if (run.whole.x[i] < inner + cut || run.whole.x[i] > outer - cut) continue;
        const double share = run.whole.rho[i] / solution.star().rho_right;
        bounds = {std::min(bounds[0], share), std::max(bounds[1], share)};
    }
    return bounds;
}

/// The part of the particles, or cells, that is in the shell.
double share_in_shell(const TubeRun& run, const TubeScene& scene) {
    const auto& waves = relativistic_solution(scene).waves();
    const double inner = waves.contact.v * scene.time, outer = waves.right.head.v * scene.time;
    const auto in_shell = [&](double x) { return x > inner && x < outer; };
    return static_cast<double>(std::count_if(run.profile.x.begin(), run.profile.x.end(), in_shell)) /
           static_cast<double>(run.profile.x.size());
}

}  // namespace

void problem_2(report::Run& run) {
    using shocks::Profile;
    TubeScene scene = problem(2);
    scene.n = 1000;
    const double low = 0.32, high = 0.37;
    const TubeEntries all = tube_figure(run, {"problem-2",
                                              scene,
                                              {{"", "ρ", &Profile::rho, low, high},
                                               {"", "$v$", &Profile::v, low, high},
                                               {"", "$P$", &Profile::p, low, high},
                                               {"", "$u$", &Profile::u, low, high, true}},
                                              true});
    const TubeEntry &classical = entry_of(all, "chow-monaghan"), &best = entry_of(all, "reconstructed"),
                    &grid = entry_of(all, "grid");
    const auto [least, most] = shell_densities(best.run, scene);
    const double spacings = best.shock.error * relativistic_solution(scene).waves().right.head.v *
                            scene.time * static_cast<double>(best.n);
    run.fill("p2-least", report::fixed(least, 2));
    run.fill("p2-most", report::fixed(most, 2));
    run.fill("p2-spike", report::number(100 * best.run.wiggle, 2));
    run.fill("p2-ahead", report::number(spacings, 2));
    run.fill("p2-particles", report::number(100 * share_in_shell(best.run, scene), 2));
    run.fill("p2-cells", report::number(100 * share_in_shell(grid.run, scene), 2));
    run.claim("p2-classical", [&] {
        return classical.shock.error > 5 * best.shock.error && classical.run.l1_rho > 3 * best.run.l1_rho;
    });
    run.claim("p2-wiggles", [&] {
        return best.run.wiggle > 0.3 && least < 0.95 && most > 1.02 && most < 1.1 && least > 0.85;
    });
    run.claim("p2-ahead", [&] { return spacings > 0.8 && spacings < 2; });
    run.claim("p2-grid", [&] {
        return best.run.l1_rho / grid.run.l1_rho > 0.75 && best.run.l1_rho / grid.run.l1_rho < 1.25 &&
               grid.run.l1_p < best.run.l1_p / 2 && grid.run.seconds < best.run.seconds / 100;
    });
}
}  // namespace sph::landau
