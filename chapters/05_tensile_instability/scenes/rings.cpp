#include "chapters/05_tensile_instability/scenes/rings.hpp"

#include <numbers>

namespace sph::tensile {
namespace {

using std::numbers::pi;
constexpr double inner = 3, outer_radius = 4;

/// Circles of particles about the origin, every other one turned by half a spacing.
std::vector<Vector<2>> ring(std::size_t layers) {
    const double dx = (outer_radius - inner) / static_cast<double>(layers);
    std::vector<Vector<2>> places;
    for (std::size_t layer = 0; layer < layers; ++layer) {
        const double r = inner + (static_cast<double>(layer) + 0.5) * dx;
        const long count = std::lround(2 * pi * r / dx);
        for (long k = 0; k < count; ++k) {
            const double turn =
                2 * pi * (static_cast<double>(k) + (layer % 2 == 0 ? 0.0 : 0.5)) / static_cast<double>(count);
            places.push_back({r * std::cos(turn), r * std::sin(turn)});
        }
    }
    return places;
}

}  // namespace

RingsRun run_rings(const RingsScene& scene, const SolidMethod& method) {
    const auto places = ring(scene.layers);
    const std::size_t each = places.size();
    const SolidSetup setup{.n = 2 * each,
                           .matter = {1, scene.shear, 1},
                           .dx = (outer_radius - inner) / static_cast<double>(scene.layers),
                           .courant = scene.courant,
                           .threads = scene.threads};
    const auto solid = make_solid(setup, method);
    const double m = pi * (outer_radius * outer_radius - inner * inner) / static_cast<double>(each);
    // Far enough from each other that no kernel reaches across.
    const double centre = outer_radius + method.h_over_dx * SolidKernel::support / 2 * setup.dx + 0.2;
    for (std::size_t i = 0; i < setup.n; ++i) {
        const double side = i < each ? -1 : 1;
        solid->place(i, places[i % each] + Vector<2>{side * centre, 0}, {-side * scene.speed, 0}, m, 1, 0);
    }
    solid->start(0);
    Drifts<2> drifts{*solid};
    RingsRun run;
    run.n = setup.n;
    double t = 0, next_look = 0;
    const double link = 2 * setup.dx;
    march(*solid, t, {.end = scene.time}, [&](double now) {
        solid->resolve(now);
        drifts.look();
        run.t.push_back(now);
        run.energy.push_back(solid->totals().energy / drifts.first().energy);
        run.energy_gain = std::max(run.energy_gain, run.energy.back() - 1);
        if (now < next_look) return;
        next_look += scene.time / 20;
        run.most_pieces = std::max(run.most_pieces, pieces_of(solid->get<Position>(), link).count);
    });
    run.x = solid->get<Position>();
    run.pieces = pieces_of(run.x, link).count;
    run.most_pieces = std::max(run.most_pieces, run.pieces);
    for (std::size_t i = 0; i < each; ++i)
        run.rebound -= solid->get<Velocity>()[0][i] / (static_cast<double>(each) * scene.speed);
    run.energy_left = run.energy.back();
    run.momentum_drift = drifts.momentum() / (m * static_cast<double>(each) * scene.speed);
    run.counters = solid->counters();
    return run;
}

report::Quantities RingsRun::measured() const {
    return {{"pieces", static_cast<double>(pieces)},
            {"rebound", rebound},
            {"energy_left", energy_left},
            {"energy_gain", energy_gain},
            {"momentum_drift", momentum_drift},
            {"steps", static_cast<double>(counters.steps)}};
}

}  // namespace sph::tensile
