#include "chapters/05_tensile_instability/scenes/elastic_wave.hpp"

#include <numbers>

namespace sph::tensile {
namespace {

constexpr double k = 2 * std::numbers::pi;

/// Where the i-th particle is at first: column by column.
Vector<2> place_of(const ElasticWaveScene& scene, std::size_t i) {
    const double dx = 1 / static_cast<double>(scene.n);
    const std::size_t column = i / scene.rows, row = i % scene.rows;
    return {(static_cast<double>(column) + 0.5) * dx, (static_cast<double>(row) + 0.5) * dx};
}
double error_of(const Solid& solid, const ElasticWaveScene& scene, std::size_t along, double phase) {
    const Column& v = solid.get<Velocity>()[along];
    double error = 0, size = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const double start = scene.amplitude * std::sin(k * place_of(scene, i)[0]);
        error += std::abs(v[i] - start * std::cos(phase));
        size += std::abs(start);
    }
    return error / size;
}

}  // namespace

std::string_view name_of(Polarisation polarisation) {
    return polarisation == Polarisation::longitudinal ? "p" : "s";
}

ElasticWaveRun run_elastic_wave(const ElasticWaveScene& scene, const SolidMethod& method) {
    SolidSetup setup{.n = scene.n * scene.rows,
                     .matter = {1, scene.shear, 1},
                     .dx = 1 / static_cast<double>(scene.n),
                     .courant = scene.courant,
                     .alpha = 0,  // no wave is exact in a viscous solid
                     .threads = scene.threads};
    const double width = static_cast<double>(scene.rows) * setup.dx;
    setup.box.emplace(Vector<2>{0, 0}, Vector<2>{1, width}, Face::periodic);
    const auto solid = make_solid(setup, method);
    const bool longitudinal = scene.polarisation == Polarisation::longitudinal;
    const std::size_t along = longitudinal ? 0 : 1;
    for (std::size_t i = 0; i < setup.n; ++i) {
        const Vector<2> x = place_of(scene, i);
        Vector<2> v{};
        v[along] = scene.amplitude * std::sin(k * x[0]);
        solid->place(i, x, v, setup.dx * setup.dx, 1, 0);
    }
    solid->start(0);
    const double c = longitudinal ? setup.matter.longitudinal_speed() : setup.matter.transverse_speed();
    Drifts<2> drifts{*solid};
    ElasticWaveRun run;
    double t = 0;
    march(*solid, t, {.end = 1 / c}, [&](double now) {
        run.error = std::max(run.error, error_of(*solid, scene, along, k * c * now));
        drifts.look();
    });
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
