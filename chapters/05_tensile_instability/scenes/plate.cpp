#include "chapters/05_tensile_instability/scenes/plate.hpp"

#include <numbers>

#include "chapters/05_tensile_instability/total_lagrangian.hpp"

namespace sph::tensile {
namespace {

using std::numbers::pi;
constexpr int first_mode = 1;

std::size_t free_columns(const PlateScene& scene) {
    return static_cast<std::size_t>(std::lround(scene.aspect * static_cast<double>(scene.rows)));
}
SolidSetup setup_of(const PlateScene& scene) {
    return {.n = scene.rows * (1 + free_columns(scene)),
            .matter = {1, scene.shear, 1},
            .dx = 1 / static_cast<double>(scene.rows),
            .courant = scene.courant,
            .threads = scene.threads};
}
/// Particle i of a plate at rest, column by column; the first column is the clamp.
Vector<2> place_of(const PlateScene& scene, std::size_t i) {
    const double dx = 1 / static_cast<double>(scene.rows);
    const std::size_t column = i / scene.rows, row = i % scene.rows;
    return {static_cast<double>(column) * dx, (static_cast<double>(row) + 0.5) * dx - 0.5};
}
/// At rest but for a velocity v_y(x), clamped.
template <class Speed>
void put(Solid& solid, const PlateScene& scene, const SolidSetup& setup, Speed&& speed) {
    for (std::size_t i = 0; i < setup.n; ++i) {
        const Vector<2> x = place_of(scene, i);
        solid.place(i, x, {0, speed(x[0])}, setup.dx * setup.dx, 1, 0);
    }
    solid.groups().hold("clamp", 0, scene.rows);
}

}  // namespace

exact::ClampedPlate exact_plate(const PlateScene& scene) {
    const Elastic matter = setup_of(scene).matter;
    const double dx = 1 / static_cast<double>(scene.rows);
    const double length = (static_cast<double>(free_columns(scene)) + 0.5) * dx;
    return {1, length, matter.young(), matter.poisson(), matter.rho0};
}

PlateRun run_plate(const PlateScene& scene, const SolidMethod& method) {
    const SolidSetup setup = setup_of(scene);
    const exact::ClampedPlate exact = exact_plate(scene);
    const auto solid = make_solid(setup, method);
    Column shape;
    for (std::size_t i = 0; i < setup.n; ++i) shape.push_back(exact.shape(first_mode, place_of(scene, i)[0]));
    put(*solid, scene, setup, [&](double x) { return scene.speed * exact.shape(first_mode, x); });
    solid->start(0);
    const double period = 2 * pi / exact.omega(first_mode);
    PlateRun run;
    double t = 0;
    march(*solid, t, {.end = 1.2 * period}, [&](double now) {
        solid->resolve(now);
        double part = 0, squares = 0;
        for (std::size_t i = 0; i < setup.n; ++i) {
            part += (solid->get<Position>()[1][i] - place_of(scene, i)[1]) * shape[i];
            squares += shape[i] * shape[i];
        }
        run.t.push_back(now / period);
        run.swing.push_back(part / squares);
        return part > 0;
    });
    run.counters = solid->counters();
    const std::size_t last = run.t.size() - 1;
    if (run.swing[last] > 0) return run;
    // The zero between the last two steps, by a straight line.
    const double share = run.swing[last] / (run.swing[last] - run.swing[last - 1]);
    run.frequency = 0.5 / (run.t[last] - share * (run.t[last] - run.t[last - 1]));
    return run;
}

BeamRun run_beam(const PlateScene& scene) {
    const SolidSetup setup = setup_of(scene);
    const exact::ClampedPlate exact = exact_plate(scene);
    constexpr double force = 1e-6;
    const double omega = exact.omega(first_mode), critical = 2 * omega;
    // A little less friction than the critical one: then the rest comes soonest.
    const auto solid = make_loaded_solid(setup, 0.8 * critical);
    put(*solid, scene, setup, [](double) { return 0.0; });
    const std::size_t first = setup.n - scene.rows;  // of the last column
    for (std::size_t i = first; i < setup.n; ++i)
        solid->get<Load>()[1][i] = force / (static_cast<double>(scene.rows) * setup.dx * setup.dx);
    solid->start(0);
    double t = 0;
    march(*solid, t, {.end = 9 / omega});
    solid->resolve(t);
    BeamRun run;
    double bent = 0;
    for (std::size_t i = first; i < setup.n; ++i) {
        bent += (solid->get<Position>()[1][i] - place_of(scene, i)[1]) / static_cast<double>(scene.rows);
        run.speed = std::max(run.speed, std::abs(solid->get<Velocity>()[1][i]));
    }
    const double length = place_of(scene, setup.n - 1)[0];  // the load acts at the last column
    const Elastic& matter = setup.matter;
    const exact::LoadedBeam beam{1, length, matter.young(), matter.poisson(), force};
    run.deflection = bent / beam.deflection(length);
    run.speed /= std::abs(bent) * omega;
    run.counters = solid->counters();
    return run;
}

report::Quantities PlateRun::measured() const {
    return {{"frequency", frequency, "exact"}, {"steps", static_cast<double>(counters.steps)}};
}
report::Quantities BeamRun::measured() const {
    return {{"deflection", deflection, "exact"}, {"steps", static_cast<double>(counters.steps)}};
}

}  // namespace sph::tensile
