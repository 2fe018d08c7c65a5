#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"

namespace sph::shocks {
namespace {

/// Two streams of n particles each in |x| < 0.5 that meet at Mach 1e4, of a gas that stays cold (gamma - 1 =
/// 1e-6): a little beyond the time at which the first two particles would be at one place.
struct Streams {
    Column x, v;
    double closest = 1;  ///< the least distance of neighbours [spacings]
    bool held = true;    ///< no error stopped them
};
Streams collide(const Method<1>& method, std::size_t n, int threads) {
    const IdealGas state{1 + 1e-6};
    const double dx = 0.5 / static_cast<double>(n), p = 1e-8 / state.gamma;
    const auto gas =
        method.make({.n = 2 * n, .state = state, .box = Box<1>{{-1}, {1}, Face::free}, .threads = threads});
    for (std::size_t i = 0; i < 2 * n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * dx - 0.5;
        gas->place(i, {x}, {x < 0 ? 1.0 : -1.0}, dx, 1, p);
    }
    gas->start(0);
    Streams streams;
    double t = 0;
    try {
        march(*gas, t, {.end = 0.8 * dx});
    } catch (const Unstable&) {
        streams.held = false;
    }
    streams.x = gas->get<Position>()[0];
    streams.v = gas->get<Velocity>()[0];
    for (std::size_t i = 0; i + 1 < 2 * n; ++i)
        streams.closest = std::min(streams.closest, (streams.x[i + 1] - streams.x[i]) / dx);
    return streams;
}

void cold_streams(report::Run& run, plot::Panel& phase) {
    report::Table table{{"cold streams, Mach 10⁴", "closest neighbours, spacings", "what happens"}};
    for (const Method<1>& method :
         tube_methods().named({"monaghan-gingold", "alpha-beta", "signal", "reconstructed"})) {
        const Streams streams = collide(method, run.quick() ? 30 : 100, run.threads());
        run.record("cold " + method.name, 200,
                   {{"closest", streams.closest, "spacings"}, {"held", streams.held ? 1.0 : 0.0}});
        table.row({method.label, streams.held ? report::number(streams.closest, 2) : "0",
                   streams.held ? "held apart" : "stopped by the typed error: the time step vanishes"});
        if (method.name == "monaghan-gingold" || method.name == "alpha-beta")
            phase.curve(streams.x, streams.v, method.styled());
    }
    phase.x_range(-0.03, 0.03).y_range(-1.1, 2);
    run.fill("colliding", table.markdown());
}

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

void noh(report::Run& run, plot::Panel& density, plot::Panel& energy) {
    TubeScene scene{{1, 1, 1e-6}, {1, -1, 1e-6}, 5.0 / 3, run.quick() ? 0.2 : 0.6};
    scene.n = run.quick() ? 60 : 400;
    scene.threads = run.threads();
    report::Table table{{"Noh, N = 400", "ρ %", "P %", "largest error of ρ behind the shock %",
                         "ρ at the wall", "u at the wall"}};
    const Profile exact = exact_profile(scene, -0.3, 0.3);
    density.curve(exact.x, exact.rho, plot::exact());
    energy.curve(exact.x, exact.u, plot::exact());
    for (const Method<1>& method : tube_methods().named({"signal", "reconstructed"})) {
        const TubeRun tube = run_tube(scene, method);
        density.points(tube.profile.x, tube.profile.rho, plot::dots(method.styled(), 2.5));
        energy.points(tube.profile.x, tube.profile.u, plot::dots(method.styled(), 2.5));
        const Plateau found = plateau(tube, scene.time / 3);
        run.record("noh " + method.name, scene.n,
                   {{"l1_rho", tube.l1_rho},
                    {"l1_p", tube.l1_p},
                    {"post_shock_rho_error", found.worst},
                    {"wall_rho", found.rho_at_wall}});
        table.row({method.label, report::percent(tube.l1_rho), report::percent(tube.l1_p),
                   report::percent(found.worst), report::number(found.rho_at_wall, 3),
                   report::number(found.u_at_wall, 3)});
    }
    for (plot::Panel* panel : {&density, &energy}) panel->x_range(-0.3, 0.3);
    run.fill("noh", table.markdown());
}

}  // namespace

void colliding(report::Run& run) {
    plot::Figure figure{"colliding", 1, 3};
    figure.panel_width = 300;
    plot::Panel& phase = figure.at(0, 0).titled("cold streams at contact").labels("$x$", "$v$");
    plot::Panel& density = figure.at(0, 1).titled("Noh, $N$ = 400").labels("$x$", "ρ");
    plot::Panel& energy = figure.at(0, 2).titled("wall heating").labels("$x$", "$u$");
    cold_streams(run, phase);
    noh(run, density, energy);
    density.legend.shown = false;
    energy.legend.outside = true;
    run.save(figure);
}

}  // namespace sph::shocks
