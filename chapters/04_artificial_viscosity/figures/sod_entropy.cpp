#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"

/// Sod's tube by chapter 3's equations alone, and with a viscosity: velocity, and what only a shock may
/// change.
namespace sph::shocks {
namespace {

/// Velocity and entropy of one method.
void draw(report::Run& run, const std::string& name, const TubeScene& scene, const TubeRun& tube,
          const Method<1>& method) {
    plot::Figure figure{name, 1, 2};
    const Profile exact = exact_profile(scene);
    plot::Panel& v = figure.at(0, 0).labels("$x$", "$v$").y_range(-0.3, 1.8);
    plot::Panel& s = figure.at(0, 1).labels("$x$", "$P$ / ρ^{γ}").x_range(0.15, 0.45).y_range(1.75, 2.15);
    v.points(tube.profile.x, tube.profile.v, plot::dots(method.styled(), 3));
    v.curve(exact.x, exact.v, plot::exact());
    s.points(tube.profile.x, entropy_of(tube.profile, scene.gamma), plot::dots(method.styled(), 3));
    s.curve(exact.x, entropy_of(exact, scene.gamma), plot::exact());
    s.legend.shown = false;
    run.save(figure);
}

}  // namespace

Entropies between_contact_and_shock(const TubeRun& tube, const TubeScene& scene) {
    const ExactTube exact = gas_tube(scene).exact;
    const double begin = exact.contact + 0.05, end = exact.jumps.front() - 0.05;
    const double before = scene.right.p / std::pow(scene.right.rho, scene.gamma);
    const Column entropy = entropy_of(tube.profile, scene.gamma), due = entropy_of(tube.exact, scene.gamma);
    Entropies found;
    double count = 0;
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
        if (tube.profile.x[i] < begin || tube.profile.x[i] > end) continue;
        ++count;
        found.noise = std::max(found.noise, std::abs(tube.profile.v[i] / tube.exact.v[i] - 1));
        found.largest_gain = std::max(found.largest_gain, entropy[i] / before - 1);
        found.gain += entropy[i] / before - 1;
        found.due = due[i] / before - 1;
    }
    found.gain /= count;
    return found;
}

Entropies follow_entropy(report::Run& run, const std::string& method_name, const std::string& figure) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    const Method<1>& method = tube_methods()[method_name];
    const TubeRun tube = run_tube(scene, method);
    draw(run, figure, scene, tube, method);
    const Entropies found = between_contact_and_shock(tube, scene);
    run.record(method_name, scene.n, {{"velocity_noise", found.noise}, {"entropy_gained", found.gain}});
    run.fill("noise-" + method_name, report::number(100 * found.noise, 2));
    run.fill("entropy-due", report::number(100 * found.due, 2));
    return found;
}

}  // namespace sph::shocks
