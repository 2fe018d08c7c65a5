#include <cmath>

#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/noh.hpp"

namespace sph::shocks {
namespace {

/// Two streams of n particles each in |x| < 0.5 that meet at Mach 1e4, of a gas that stays cold (gamma - 1 =
/// 1e-6): a little beyond the time at which the first two particles would be at one place.
struct Streams {
    Column x, v;
    double closest = 0;   ///< the least distance of neighbours [spacings]
    std::string stopped;  ///< the error, if any
};
Streams collide(const Method& method, std::size_t n, int threads) {
    const double gamma = 1 + 1e-6, dx = 0.5 / static_cast<double>(n), p = 1e-8 / gamma;
    const auto gas = make_model(method, 2 * n, gamma, Box<1>{{-1}, {1}, Face::free}, threads);
    for (std::size_t i = 0; i < 2 * n; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * dx - 0.5;
        gas->set(i, {x}, {x < 0 ? 1.0 : -1.0}, dx, 1, p / (gamma - 1));
    }
    Streams streams;
    double t = 0;
    try {
        gas->advance(t, 0.8 * dx, 0.45);
    } catch (const Unstable& failure) {
        streams.stopped = failure.what();
    }
    streams.x = gas->x()[0];
    streams.v = gas->v()[0];
    streams.closest = 1;
    for (std::size_t i = 0; i + 1 < 2 * n; ++i)
        streams.closest = std::min(streams.closest, (streams.x[i + 1] - streams.x[i]) / dx);
    return streams;
}

}  // namespace

void colliding(report::Run& run) {
    plot::Figure figure{"colliding", 1, 3};
    figure.panel_width = 300;
    plot::Panel& phase = figure.at(0, 0).titled("cold streams at contact").labels("$x$", "$v$");
    plot::Panel& density = figure.at(0, 1).titled("Noh, $N$ = 400").labels("$x$", "ρ");
    plot::Panel& energy = figure.at(0, 2).titled("wall heating").labels("$x$", "$u$");
    report::Table crossing{{"cold streams, Mach 10⁴", "closest neighbours, spacings", "what happens"}};
    for (const std::string name : {"monaghan-gingold", "alpha-beta", "signal", "reconstructed"}) {
        const Streams streams = collide(tube_method(name), run.quick() ? 30 : 100, run.threads());
        const bool held = streams.stopped.empty();
        run.result("cold " + name, 200, "closest", streams.closest, "spacings");
        run.result("cold " + name, 200, "held", held ? 1 : 0);
        crossing.row({tube_method(name).label, held ? report::number(streams.closest, 2) : "0",
                      held ? "held apart" : "stopped by the typed error: the time step vanishes"});
        if (name == "monaghan-gingold" || name == "alpha-beta")
            phase.curve(streams.x, streams.v, style_of(name));
    }
    phase.x_range(-0.03, 0.03).y_range(-1.1, 2);

    TubeScene noh{{1, 1, 1e-6}, {1, -1, 1e-6}, 5.0 / 3, run.quick() ? 0.2 : 0.6};
    noh.n = run.quick() ? 60 : 400;
    noh.threads = run.threads();
    report::Table table{{"Noh, N = 400", "ρ %", "P %", "largest error of ρ behind the shock %",
                         "ρ at the wall", "u at the wall"}};
    const double shock = noh.time / 3;
    const Profile exact = exact_profile(noh, -0.3, 0.3);
    density.curve(exact.x, exact.rho, exact_line());
    energy.curve(exact.x, exact.u, exact_line());
    for (const std::string name : {"signal", "reconstructed"}) {
        const TubeRun tube = run_tube(noh, tube_method(name));
        density.points(tube.profile.x, tube.profile.rho, dots(style_of(name), 2.5));
        energy.points(tube.profile.x, tube.profile.u, dots(style_of(name), 2.5));
        double worst = 0, at_wall = 0, u_wall = 0, nearest = 1;
        for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
            const double x = std::abs(tube.profile.x[i]);
            if (x > 0.15 * shock && x < 0.85 * shock)
                worst = std::max(worst, std::abs(tube.profile.rho[i] / 4 - 1));
            if (x < nearest) nearest = x, at_wall = tube.profile.rho[i], u_wall = tube.profile.u[i];
        }
        const auto n = static_cast<long>(noh.n);
        run.result("noh " + name, n, "l1_rho", tube.l1_rho);
        run.result("noh " + name, n, "l1_p", tube.l1_p);
        run.result("noh " + name, n, "post_shock_rho_error", worst);
        run.result("noh " + name, n, "wall_rho", at_wall);
        table.row({tube_method(name).label, report::number(100 * tube.l1_rho, 2),
                   report::number(100 * tube.l1_p, 2), report::number(100 * worst, 2),
                   report::number(at_wall, 3), report::number(u_wall, 3)});
    }
    for (plot::Panel* panel : {&density, &energy}) panel->x_range(-0.3, 0.3);
    density.legend.shown = false;
    energy.legend.outside = true;
    run.save(figure);
    run.fill("colliding", crossing.markdown());
    run.fill("noh", table.markdown());
}

void expansion(report::Run& run) {
    plot::Figure figure{"expansion", 1, 3};
    figure.panel_width = 300;
    plot::Panel& rho = figure.at(0, 0).titled("123 problem, 200 particles").labels("$x$", "ρ");
    plot::Panel& u = figure.at(0, 1).labels("$x$", "$u$");
    plot::Panel& empty = figure.at(0, 2).log_y().titled("into a vacuum, 200 particles").labels("$x$", "ρ");
    TubeScene scene{{1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.15};
    scene.n = run.quick() ? 60 : 200;
    TubeScene vacuum{{1, 0, 1}, {0, 0, 0}, 1.4, 0.1};
    vacuum.n = scene.n;
    report::Table table{{"method", "123: ρ %", "v %", "P %", "u %", "vacuum: ρ %", "v %"}};
    const Profile exact_apart = exact_profile(scene), exact_into = exact_profile(vacuum);
    rho.curve(exact_apart.x, exact_apart.rho, exact_line());
    u.curve(exact_apart.x, exact_apart.u, exact_line());
    Column x, density;  // a logarithmic axis has no vacuum
    for (std::size_t i = 0; i < exact_into.x.size(); ++i) {
        if (exact_into.rho[i] < 1e-3) continue;
        x.push_back(exact_into.x[i]);
        density.push_back(exact_into.rho[i]);
    }
    empty.curve(x, density, exact_line());
    for (const std::string name : {"signal", "price", "reconstructed"}) {
        const TubeRun apart = run_tube(scene, tube_method(name)), into = run_tube(vacuum, tube_method(name));
        rho.points(apart.profile.x, apart.profile.rho, dots(style_of(name)));
        u.points(apart.profile.x, apart.profile.u, dots(style_of(name)));
        empty.points(into.profile.x, into.profile.rho, dots(style_of(name)));
        const auto n = static_cast<long>(scene.n);
        run.result("123 " + name, n, "l1_rho", apart.l1_rho);
        run.result("123 " + name, n, "l1_u", apart.l1_u);
        run.result("vacuum " + name, n, "l1_rho", into.l1_rho);
        run.result("vacuum " + name, n, "l1_v", into.l1_v);
        std::vector<std::string> row{tube_method(name).label};
        for (const double error : {apart.l1_rho, apart.l1_v, apart.l1_p, apart.l1_u, into.l1_rho, into.l1_v})
            row.push_back(report::number(100 * error, 2));
        table.row(row);
    }
    rho.legend.shown = false;
    u.legend.shown = false;
    empty.legend.outside = true;
    run.save(figure);
    run.fill("expansion", table.markdown());
}

}  // namespace sph::shocks
