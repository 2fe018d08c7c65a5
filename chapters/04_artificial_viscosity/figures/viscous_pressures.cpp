#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"

namespace sph::shocks {
namespace {

/// The largest relative error of v between the contact and the shock, half a shock's width away from both.
double velocity_noise(const TubeRun& tube) {
    double worst = 0;
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
        const double x = tube.profile.x[i];
        if (x > 0.2 && x < 0.32) worst = std::max(worst, std::abs(tube.profile.v[i] / tube.exact.v[i] - 1));
    }
    return worst;
}

}  // namespace

void viscous_pressures(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    plot::Figure figure{"viscous-pressures", 1, 3};
    figure.panel_width = 300;
    const Profile exact = exact_profile(scene, 0, 0.45);
    int column = 0;
    for (const Method<1>& method : tube_methods().named({"von-neumann", "bulk", "monaghan-gingold"})) {
        plot::Panel& v = figure.at(0, column++).titled(method.label).labels("$x$", "$v$");
        v.x_range(0, 0.45).y_range(-0.1, 1.2);
        const TubeRun tube = run_tube(scene, method);
        v.curve(exact.x, exact.v, plot::exact());
        v.points(tube.profile.x, tube.profile.v, plot::dots(method.styled()));
        v.legend.shown = false;
        const double noise = velocity_noise(tube);
        run.record(method.name, scene.n, {{"velocity_noise", noise}});
        run.fill("noise-" + method.name, report::number(100 * noise, 1));
    }
    run.save(figure);
}

}  // namespace sph::shocks
