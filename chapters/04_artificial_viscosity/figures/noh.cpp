#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"

/// Noh's problem on a line: the wall that heats.
namespace sph::shocks {
namespace {

/// What Noh's problem leaves behind its shock, where rho is 4.
struct Plateau {
    double worst = 0, rho_at_wall = 0, u_at_wall = 0;
};
Plateau plateau(const TubeRun& tube, double shock) {
    Plateau found;
    double nearest = 1;
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
        const double x = std::abs(tube.profile.x[i]);
        if (x > 0.15 * shock && x < 0.85 * shock)
            found.worst = std::max(found.worst, std::abs(tube.profile.rho[i] / 4 - 1));
        if (x < nearest)
            nearest = x, found.rho_at_wall = tube.profile.rho[i], found.u_at_wall = tube.profile.u[i];
    }
    return found;
}

void run_walls(report::Run& run, plot::Panel& density, plot::Panel& energy) {
    TubeScene scene{{1, 1, 1e-6}, {1, -1, 1e-6}, 5.0 / 3, run.quick() ? 0.2 : 0.6};
    scene.n = run.quick() ? 60 : 400;
    scene.threads = run.threads();
    std::vector<Plateau> walls;
    report::Table table{{"Noh, N = 400", "ρ %", "P %", "largest error of ρ behind the shock %",
                         "ρ at the wall", "u at the wall"}};
    for (const Method<1>& method : tube_methods().named({"signal", "reconstructed"})) {
        const TubeRun tube = run_tube(scene, method);
        density.points(tube.profile.x, tube.profile.rho, plot::dots(method.styled(), 2.5));
        energy.points(tube.profile.x, tube.profile.u, plot::dots(method.styled(), 2.5));
        const Plateau found = plateau(tube, scene.time / 3);
        run.record(method.name, scene.n,
                   {{"l1_rho", tube.l1_rho},
                    {"l1_p", tube.l1_p},
                    {"post_shock_rho_error", found.worst},
                    {"wall_rho", found.rho_at_wall}});
        walls.push_back(found);
        table.row({method.label, report::percent(tube.l1_rho), report::percent(tube.l1_p),
                   report::percent(found.worst), report::number(found.rho_at_wall, 3),
                   report::number(found.u_at_wall, 3)});
    }
    const Profile exact = exact_profile(scene, -0.3, 0.3);
    density.curve(exact.x, exact.rho, plot::exact());
    energy.curve(exact.x, exact.u, plot::exact());
    for (plot::Panel* panel : {&density, &energy}) panel->x_range(-0.3, 0.3);
    run.fill("noh", table.markdown());
    // Exact: rho = 4, u = 1/2.
    run.claim(
        "wall-heating",
        [&] {
            const Plateau &signal = walls[0], &best = walls[1];
            return signal.u_at_wall > best.u_at_wall && best.u_at_wall > 0.55 &&
                   signal.rho_at_wall < best.rho_at_wall && best.rho_at_wall < 3.7;
        },
        report::Needs::any_run);
}

}  // namespace

void noh(report::Run& run) {
    plot::Figure figure{"noh", 1, 2};
    plot::Panel& density = figure.at(0, 0).labels("$x$", "ρ");
    plot::Panel& energy = figure.at(0, 1).labels("$x$", "$u$");
    run_walls(run, density, energy);
    density.legend.shown = false;
    run.save(figure);
}

}  // namespace sph::shocks
