#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"

/// Sod's tube by chapter 3's equations alone, and with a viscosity: velocity, and what only a shock may
/// change.
namespace sph::shocks {
namespace {

/// The largest relative error of f between contact and shock, five hundredths away from both.
double worst_behind_shock(const TubeRun& tube, const ExactTube& exact, Column Profile::*f) {
    const double begin = exact.contact + 0.05, end = exact.jumps.front() - 0.05;
    double worst = 0;
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
        const double x = tube.profile.x[i];
        if (x > begin && x < end)
            worst = std::max(worst, std::abs((tube.profile.*f)[i] / (tube.exact.*f)[i] - 1));
    }
    return worst;
}

/// The largest relative change of entropy of the particles that the shock has passed.
double entropy_gained(const TubeRun& tube, const TubeScene& scene) {
    const double before = scene.right.p / std::pow(scene.right.rho, scene.gamma);
    const Column entropy = entropy_of(tube.profile, scene.gamma);
    const ExactTube exact = gas_tube(scene).exact;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < entropy.size(); ++i) {
        if (tube.profile.x[i] < exact.contact + 0.05 || tube.profile.x[i] > exact.jumps.front() - 0.05)
            continue;
        sum += entropy[i] / before - 1, ++count;
    }
    return sum / count;
}

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

Entropies follow_entropy(report::Run& run, const std::string& method_name, const std::string& figure) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    const Method<1>& method = tube_methods()[method_name];
    const TubeRun tube = run_tube(scene, method);
    draw(run, figure, scene, tube, method);
    const ExactTube exact = gas_tube(scene).exact;
    const Profile after = exact_profile(scene, exact.contact + 0.06, exact.contact + 0.07);
    const double before = scene.right.p / std::pow(scene.right.rho, scene.gamma);
    const Entropies found{worst_behind_shock(tube, exact, &Profile::v), entropy_gained(tube, scene),
                          entropy_of(after, scene.gamma)[0] / before - 1};
    run.record(method_name, scene.n, {{"velocity_noise", found.noise}, {"entropy_gained", found.gain}});
    run.fill("noise-" + method_name, report::number(100 * found.noise, 2));
    run.fill("entropy-due", report::number(100 * found.due, 2));
    return found;
}

}  // namespace sph::shocks
