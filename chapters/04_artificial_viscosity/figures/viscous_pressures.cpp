#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"
#include "common/plot/looks.hpp"

namespace sph::shocks {
void viscous_pressures(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    plot::Figure figure{"viscous-pressures", 3, 3};
    figure.panel_width = 300;
    figure.panel_height = 200;
    figure.share_x = figure.share_y = true;
    const Profile exact = exact_profile(scene, 0, 0.45);
    int column = 0;
    std::vector<double> noises;
    for (const Method<1>& method : tube_methods().named({"von-neumann", "bulk", "monaghan-gingold"})) {
        const TubeRun tube = run_tube(scene, method);
        const auto draw = [&](int row, const char* label, double low, double high, Column Profile::*f) {
            plot::Panel& panel =
                figure.at(row, column).labels(row == 2 ? "$x$" : "", column == 0 ? label : "");
            panel.x_range(0, 0.45).y_range(low, high);
            panel.points(tube.profile.x, tube.profile.*f, plot::dots(method.styled()));
            panel.curve(exact.x, exact.*f, plot::exact());
            panel.legend.shown = false;
        };
        draw(0, "$v$", -0.1, 1.2, &Profile::v);
        draw(1, "$P$", 0.05, 0.4, &Profile::p);
        draw(2, "ρ", 0.1, 0.5, &Profile::rho);
        figure.at(0, column++).titled(method.label);
        const double noise = between_contact_and_shock(tube, scene).noise;
        run.record(method.name, scene.n, {{"velocity_noise", noise}});
        run.fill("noise-" + method.name, report::number(100 * noise, 1));
        noises.push_back(noise);
    }
    run.claim("pairs-see-neighbours", [&] { return noises[0] > 4 * noises[2] && noises[1] > 2 * noises[2]; });
    run.save(figure);
}

}  // namespace sph::shocks
