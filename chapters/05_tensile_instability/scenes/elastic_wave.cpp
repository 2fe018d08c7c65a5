#include "chapters/05_tensile_instability/scenes/elastic_wave.hpp"

#include <numbers>

namespace sph::tensile {
namespace {

constexpr double k = 2 * std::numbers::pi;

/// Where the i-th particle is at first: column by column.
Vector<2> place_of(const ElasticWaveScene& scene, std::size_t i) {
    const double dx = scene.spacing();
    const std::size_t column = i / scene.rows, row = i % scene.rows;
    return {(static_cast<double>(column) + 0.5) * dx, (static_cast<double>(row) + 0.5) * dx};
}

}  // namespace

std::string_view name_of(Polarisation polarisation) {
    return polarisation == Polarisation::longitudinal ? "p" : "s";
}

double standing_error(const Column& v, const Column& start, double phase) {
    double error = 0, size = 0;
    const double now = std::cos(phase);
    for (std::size_t i = 0; i < v.size(); ++i) {
        error += std::abs(v[i] - start[i] * now);
        size += std::abs(start[i]);
    }
    return error / size;
}

ElasticWaveRun run_elastic_wave(const ElasticWaveScene& scene, const SolidMethod& method) {
    SolidSetup setup{.n = scene.n * scene.rows,
                     .matter = scene.matter(),
                     .dx = scene.spacing(),
                     .courant = scene.courant,
                     .alpha = 0,  // no wave is exact in a viscous solid
                     .threads = scene.threads};
    const double width = static_cast<double>(scene.rows) * setup.dx;
    setup.box.emplace(Vector<2>{0, 0}, Vector<2>{1, width}, Face::periodic);
    const auto solid = make_solid(setup, method);
    const std::size_t along = scene.longitudinal() ? 0 : 1;
    Column start;
    for (std::size_t i = 0; i < setup.n; ++i) {
        const Vector<2> x = place_of(scene, i);
        Vector<2> v{};
        start.push_back(v[along] = scene.amplitude * std::sin(k * x[0]));
        solid->place(i, x, v, setup.dx * setup.dx, 1, 0);
    }
    solid->start(0);
    Drifts<2> drifts{*solid};
    ElasticWaveRun run;
    double t = 0;
    const Marched done = march(*solid, t, {.end = 1 / scene.speed()}, [&](double now) {
        const Column& v = solid->get<Velocity>()[along];
        run.error = std::max(run.error, standing_error(v, start, k * scene.speed() * now));
        drifts.look();
    });
    run.seconds = done.seconds;
    run.momentum_drift = drifts.momentum() / (width * scene.amplitude);
    run.counters = solid->counters();
    return run;
}

report::Quantities ElasticWaveRun::measured() const {
    return {{"l1_v", error},
            {"momentum_drift", momentum_drift},
            {"pairs", static_cast<double>(counters.pairs)},
            {"steps", static_cast<double>(counters.steps)}};
}

}  // namespace sph::tensile
