#include "chapters/03_euler_sph/scenes/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/plot/looks.hpp"
#include "common/report/chapter.hpp"

/// An eccentric orbit for long: leapfrog against RK4, at equal steps and at equal cost.
namespace sph::euler {
namespace {

struct Rider {
    std::string name, integrator, label;
    long evaluations;
    std::size_t colour;
    plot::Marker marker;
    OrbitRun run{};
};

void draw(plot::Panel& orbit, plot::Panel& energy, const Rider& rider) {
    const plot::Style look{.label = rider.label, .colour = plot::cycle(rider.colour), .marker = rider.marker};
    plot::Values change;
    for (const double value : rider.run.energy) change.push_back(std::max(1e-13, std::abs(value)));
    plot::Values x, y;
    const std::size_t every = std::max<std::size_t>(1, rider.run.x.size() / 100);
    for (std::size_t k = 0; k < rider.run.x.size(); k += every) {
        x.push_back(rider.run.x[k]);
        y.push_back(rider.run.y[k]);
    }
    orbit.points(x, y, plot::dots(look, 3));
    energy.curve(rider.run.period, change, plot::line(look));
}

}  // namespace

void orbit(report::Run& run) {
    plot::Figure figure{"orbit", 1, 2};
    plot::Panel& left = figure.at(0, 0).titled("the last period").labels("$x$", "$y$");
    plot::Panel& right =
        figure.at(0, 1).log_y().titled("energy, once a period").labels("periods", "| Δ$E$ / $E$ |");
    left.equal_aspect = true;
    right.y_range(1e-13, 1);
    const OrbitScene scene{.periods = run.quick() ? 10 : 100};
    std::vector<Rider> riders{
        {"RK4", "RK4", "RK4, equal cost", scene.evaluations, 2, plot::Marker::triangle_up},
        {"RK4 equal step", "RK4", "RK4, equal step", 4 * scene.evaluations, 3, plot::Marker::diamond},
        {"leapfrog", "leapfrog", "leapfrog", scene.evaluations, 0, plot::Marker::circle}};
    plot::Values ellipse_x, ellipse_y;
    for (int k = 0; k <= 200; ++k) {
        const double angle = std::numbers::pi * k / 100, e = scene.eccentricity;
        ellipse_x.push_back(e + std::cos(angle));
        ellipse_y.push_back(std::sqrt(1 - e * e) * std::sin(angle));
    }
    report::Table table{{"integrator", "evaluations per period", "energy", "angular momentum",
                         "turn of the axis [rad]", "distance from the exact place"}};
    for (Rider& rider : riders) {
        rider.run = run_orbit(
            {.evaluations = rider.evaluations, .periods = scene.periods, .integrator = rider.integrator});
        const OrbitRun& one = rider.run;
        draw(left, right, rider);
        run.record(rider.name, 1,
                   {{"energy_drift", one.energy.back()},
                    {"angular_momentum_drift", one.angular_momentum},
                    {"turn", one.turn, "rad"},
                    {"distance", one.miss}});
        table.row({rider.label, std::to_string(rider.evaluations), report::number(one.energy.back(), 1),
                   one.angular_momentum < 1e-11 ? "rounding" : report::number(one.angular_momentum, 1),
                   report::number(one.turn, 1), report::number(one.miss, 1)});
    }
    left.curve(ellipse_x, ellipse_y, plot::exact());
    left.legend.shown = false;
    run.save(figure);
    run.fill("orbit", table.markdown());
    const OrbitRun &equal_cost = riders[0].run, &equal_step = riders[1].run, &leapfrog = riders[2].run;
    run.claim("orbit-is-kept", [&] {
        return std::abs(leapfrog.energy.back()) < 1e-5 && leapfrog.angular_momentum < 1e-11 &&
               equal_cost.energy.back() > 0.1;
    });
    run.claim("orbit-turns", [&] {
        return std::abs(leapfrog.turn) > 0.1 && std::abs(equal_step.turn) < std::abs(leapfrog.turn) / 10 &&
               equal_step.miss < leapfrog.miss;
    });
}

}  // namespace sph::euler
