#include "chapters/05_tensile_instability/scenes/elastic_disc.hpp"

#include <numbers>

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "common/core/neighbours.hpp"
#include "common/core/unstable.hpp"

namespace sph::tensile {
namespace {

using std::numbers::pi;

/// The points, and behind them the images of those within `reach` of the unit circle, mirrored at it.
Columns<2> with_images(Columns<2> x, double reach) {
    const std::size_t n = x[0].size();
    for (std::size_t i = 0; i < n; ++i) {
        const double r = std::hypot(x[0][i], x[1][i]);
        if (r < 1 - reach) continue;
        for (std::size_t a = 0; a < 2; ++a) x[a].push_back((2 - r) / r * x[a][i]);
    }
    return x;
}

}  // namespace

Columns<2> relaxed_disc(std::size_t n, int threads) {
    const double dx = std::sqrt(pi / static_cast<double>(n)), golden = pi * (3 - std::sqrt(5.0));
    Columns<2> x;
    for (std::size_t i = 0; i < n; ++i) {
        const double k = static_cast<double>(i), r = std::sqrt((k + 0.5) / static_cast<double>(n));
        x[0].push_back(r * std::cos(k * golden)), x[1].push_back(r * std::sin(k * golden));
    }
    const ConstantH<SolidKernel> smoothing{1.2 * dx};
    Neighbours<2> neighbours{Free{}, threads};
    Particles<2, Position, Volume, Quantity, PlainGradient> p;
    constexpr int rounds = 100;
    constexpr double step = 0.1;  // [dx^2]: small enough that nearest neighbours do not overshoot
    for (int round = 0; round < rounds; ++round) {
        p.x = with_images(x, smoothing.reach());
        p.resize(p.x[0].size());
        p.V.assign(p.size(), dx * dx), p.A.assign(p.size(), 1);
        neighbours.find(p.x, smoothing.reach());
        sum_over_neighbours(p, neighbours, smoothing, Effects{PlainGradient{}});
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t a = 0; a < 2; ++a) x[a][i] -= step * dx * dx * p.plain[a][i];
            const double inside = std::min(1.0, (1 - 0.5 * dx) / std::hypot(x[0][i], x[1][i]));
            for (std::size_t a = 0; a < 2; ++a) x[a][i] *= inside;
        }
    }
    return x;
}

ElasticDiscRun run_elastic_disc(const ElasticDiscScene& scene, const SolidMethod& given) {
    SolidMethod method = given;
    if (method.law == Law::total_lagrangian) method.h_over_dx = 1;
    const SolidSetup setup{.n = scene.n,
                           .matter = {1, scene.shear, 1},
                           .dx = std::sqrt(pi / static_cast<double>(scene.n)),
                           .courant = scene.courant,
                           .threads = scene.threads};
    const auto solid = make_solid(setup, method);
    const Columns<2> places = relaxed_disc(scene.n, scene.threads);
    ElasticDiscRun run;
    for (std::size_t i = 0; i < scene.n; ++i) {
        const Vector<2> x{places[0][i], places[1][i]};
        solid->place(i, x, scene.speed * x, setup.dx * setup.dx, 1, 0);
        run.radius.push_back(std::sqrt(dot(x, x)));
    }
    solid->start(0);
    Drifts<2> drifts{*solid};
    run.x = places;
    double t = 0;
    try {
        march(*solid, t, {.end = scene.time}, [&](double now) {
            solid->resolve(now);
            drifts.look();
            run.x = solid->get<Position>();
            run.energy_left = solid->totals().energy / drifts.first().energy;
            run.reached = now;
            ++run.steps;
        });
    } catch (const Unstable&) {  // what it came to is the result
    }
    run.pieces = pieces_of(run.x, 2 * setup.dx);
    run.largest_share = static_cast<double>(run.pieces.largest) / static_cast<double>(scene.n);
    run.momentum_drift = drifts.momentum() / (drifts.first().mass * scene.speed);
    return run;
}

report::Quantities ElasticDiscRun::measured() const {
    return {{"pieces", static_cast<double>(pieces.count)},
            {"largest_piece", largest_share},
            {"energy_left", energy_left},
            {"momentum_drift", momentum_drift},
            {"time", reached, "R/c"},
            {"steps", static_cast<double>(steps)}};
}

void ElasticDiscCommand::declare(app::CommandLine& line) {
    line.choice("method", method_, solid_methods().names(), "how stress is computed")
        .integer("particles", particles_, 50, 20000, "of the disc")
        .number("shear", shear_, {0.01, 1.4}, "K", "shear modulus mu")
        .number("speed", speed_, {0.001, 2}, "sqrt(K/rho)", "of the rim at first, outwards")
        .number("time", time_, {0.1, 1000}, "R/sqrt(K/rho)", "how long");
}

void ElasticDiscCommand::run(report::Run& run) const {
    ElasticDiscScene scene;
    scene.n = static_cast<std::size_t>(particles_);
    scene.shear = shear_;
    scene.speed = speed_;
    scene.time = time_;
    scene.threads = run.threads();
    const ElasticDiscRun disc = run_elastic_disc(scene, solid_methods()[method_]);
    run.record(method_, scene.n, disc.measured());
    run.write("profile.csv", report::csv({{"x", disc.x[0]}, {"y", disc.x[1]}, {"start_r", disc.radius}}));
    plot::Figure figure{"elastic-disc"};
    plot::Panel& places = figure.panel().labels("$x$", "$y$");
    places.equal_aspect = true;
    places.particles({.name = "radius",
                      .x = disc.x[0],
                      .y = disc.x[1],
                      .value = disc.radius,
                      .bar = {.label = "radius at first"}});
    run.save(figure);
}

}  // namespace sph::tensile
