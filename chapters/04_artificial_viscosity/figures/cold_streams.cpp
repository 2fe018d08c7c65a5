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

void draw_streams(report::Run& run, plot::Figure& figure) {
    std::vector<double> closest;
    report::Table table{{"cold streams, Mach 10⁴", "closest neighbours, spacings", "what happens"}};
    for (const Method<1>& method :
         tube_methods().named({"monaghan-gingold", "alpha-beta", "signal", "reconstructed"})) {
        const Streams streams = collide(method, run.quick() ? 30 : 100, run.threads());
        closest.push_back(streams.held ? streams.closest : 0);
        run.record(method.name, 200,
                   {{"closest", streams.closest, "spacings"}, {"held", streams.held ? 1.0 : 0.0}});
        table.row({method.label, streams.held ? report::number(streams.closest, 2) : "0",
                   streams.held ? "held apart" : "stopped by the typed error: the time step vanishes"});
        if (method.name != "monaghan-gingold" && method.name != "alpha-beta") continue;
        const bool first = method.name == "monaghan-gingold";
        plot::Panel& phase = figure.at(0, first ? 0 : 1).titled(first ? "α = 1 alone" : "α = 1, β = 2");
        phase.labels("$x$", "$v$").x_range(-0.03, 0.03).y_range(-1.3, 1.3).legend.shown = false;
        phase.curve(streams.x, streams.v, method.styled());
    }
    run.fill("cold-streams", table.markdown());
    run.claim(
        "beta-holds-apart", [&] { return closest[0] == 0 && closest[1] > 0.2; }, report::Needs::any_run);
}

}  // namespace

void cold_streams(report::Run& run) {
    plot::Figure figure{"cold-streams", 1, 2};
    figure.share_y = true;
    draw_streams(run, figure);
    run.save(figure);
}

}  // namespace sph::shocks
