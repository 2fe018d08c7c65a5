#include "chapters/05_tensile_instability/scenes/wheel.hpp"

#include <numbers>

#include "common/core/unstable.hpp"

namespace sph::tensile {
namespace {

using std::numbers::pi;

/// A square lattice within the unit circle.
std::vector<Vector<2>> disc(std::size_t across) {
    const double dx = 2 / static_cast<double>(across);
    std::vector<Vector<2>> places;
    for (std::size_t a = 0; a < across; ++a) {
        for (std::size_t b = 0; b < across; ++b) {
            const Vector<2> x{(static_cast<double>(a) + 0.5) * dx - 1,
                              (static_cast<double>(b) + 0.5) * dx - 1};
            if (dot(x, x) < 1) places.push_back(x);
        }
    }
    return places;
}

}  // namespace

WheelRun run_wheel(const WheelScene& scene, const SolidMethod& method) {
    const auto places = disc(scene.across);
    const SolidSetup setup{.n = places.size(),
                           .matter = {1, scene.shear, 1},
                           .dx = 2 / static_cast<double>(scene.across),
                           .courant = scene.courant,
                           .threads = scene.threads};
    const auto solid = make_solid(setup, method);
    const double speed = scene.rim * setup.matter.longitudinal_speed(), turn = 2 * pi / speed;
    WheelRun run;
    run.n = setup.n;
    for (std::size_t i = 0; i < setup.n; ++i) {
        const Vector<2> x = places[i];
        solid->place(i, x, {-speed * x[1], speed * x[0]}, setup.dx * setup.dx, 1, 0);
        run.angle.push_back(std::atan2(x[1], x[0]));
    }
    solid->start(0);
    Drifts<2> drifts{*solid};
    const double start = angular_momentum(*solid);
    double t = 0;
    try {
        march(*solid, t, {.end = scene.turns * turn}, [&](double now) {
            solid->resolve(now);
            drifts.look();
            run.t.push_back(now / turn);
            run.change.push_back(angular_momentum(*solid) / start - 1);
            run.loss = std::max(run.loss, std::abs(run.change.back()));
            if (run.t.back() <= 0.5) run.after_half = run.change.back();
            if (run.t.back() <= 1 + 1e-9) run.after_one = run.change.back();
            run.x = solid->get<Position>();
        });
    } catch (const Unstable&) {  // what it came to is the result
    }
    run.turns = run.t.empty() ? 0 : run.t.back();
    run.energy_drift = drifts.energy() / drifts.first().energy;
    run.momentum_drift = drifts.momentum() / (drifts.first().mass * speed);
    return run;
}

report::Quantities WheelRun::measured() const {
    return {{"angular_momentum_drift", loss},
            {"after_half", after_half},
            {"after_one", after_one},
            {"turns", turns},
            {"energy_drift", energy_drift},
            {"momentum_drift", momentum_drift},
            {"steps", static_cast<double>(t.size())}};
}

void WheelCommand::declare(app::CommandLine& line) {
    line.choice("method", method_, solid_methods().names(), "how stress is computed")
        .integer("particles", across_, 8, 200, "across the wheel")
        .number("shear", shear_, {0.01, 1.4}, "K", "shear modulus mu")
        .number("rim", rim_, {0.001, 0.5}, "c_l", "speed of the rim")
        .number("turns", turns_, {0.1, 100}, "", "how far it turns");
}

void WheelCommand::run(report::Run& run) const {
    WheelScene scene;
    scene.across = static_cast<std::size_t>(across_);
    scene.shear = shear_;
    scene.rim = rim_;
    scene.turns = turns_;
    scene.threads = run.threads();
    const WheelRun wheel = run_wheel(scene, solid_methods()[method_]);
    if (wheel.t.empty()) throw Unstable{0, Unstable::no_particle, "the wheel, at its first step", 0};
    run.record(method_, wheel.n, wheel.measured());
    run.write("profile.csv", report::csv({{"turns", wheel.t}, {"angular_momentum_change", wheel.change}}));
    plot::Figure figure{"wheel", 1, 2};
    figure.at(0, 0).labels("turns", "$L$/$L$_{0} − 1").curve(wheel.t, wheel.change);
    plot::Panel& places = figure.at(0, 1).labels("$x$", "$y$");
    places.equal_aspect = true;
    places.particles({.name = "angle",
                      .x = wheel.x[0],
                      .y = wheel.x[1],
                      .value = wheel.angle,
                      .bar = {.label = "angle at first"}});
    run.save(figure);
}

}  // namespace sph::tensile
