#include "chapters/05_tensile_instability/scenes/cure.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/05_tensile_instability/scenes/response.hpp"
#include "common/app/clock.hpp"

namespace sph::tensile {
namespace {

constexpr int samples = 20;

CureSetup setup_of(const CureScene& scene) {
    CureSetup setup;
    setup.box.per_side = scene.n, setup.box.pressure = scene.pressure, setup.box.jitter = scene.jitter;
    setup.box.seed = scene.seed, setup.box.courant = scene.courant, setup.box.threads = scene.threads;
    setup.drop = scene.drop;
    return setup;
}

/// Another particle, seen from one: the nearest of its images.
struct Seen {
    double r2, angle;
};
std::vector<Seen> nearest_of(const Columns<2>& x, std::size_t i, const Vector<2>& side, std::size_t count) {
    std::vector<Seen> seen;
    for (std::size_t j = 0; j < x[0].size(); ++j) {
        Vector<2> apart{x[0][j] - x[0][i], x[1][j] - x[1][i]};
        for (std::size_t a = 0; a < 2; ++a) apart[a] -= side[a] * std::round(apart[a] / side[a]);
        if (j != i) seen.push_back({dot(apart, apart), std::atan2(apart[1], apart[0])});
    }
    const auto last = seen.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(seen.begin(), last, seen.end(),
                      [](const Seen& a, const Seen& b) { return a.r2 < b.r2; });
    seen.resize(count);
    return seen;
}
Vector<2> side_of(const Box<2>& box) {
    return {box.high[0] - box.low[0], box.high[1] - box.low[1]};
}
double folded(const std::vector<Seen>& seen, std::size_t k) {
    std::complex<double> sum = 0;
    for (std::size_t one = 0; one < k; ++one)
        sum += std::polar(1.0, static_cast<double>(k) * seen[one].angle);
    return std::abs(sum) / static_cast<double>(k);
}
double smallest_distance(const Columns<2>& x, const Box<2>& box) {
    double least = 1e300;
    for (std::size_t i = 0; i < x[0].size(); ++i)
        least = std::min(least, nearest_of(x, i, side_of(box), 1).front().r2);
    return std::sqrt(least);
}

double shear_amplitude(const Columns<2>& x, const Columns<2>& v, double side) {
    double sum = 0;
    for (std::size_t i = 0; i < x[0].size(); ++i) sum += v[0][i] * std::sin(2 * pi * x[1][i] / side);
    return 2 * sum / static_cast<double>(x[0].size());
}
double radius(const Columns<2>& x) {
    Vector<2> middle{};
    const auto n = static_cast<double>(x[0].size());
    for (std::size_t i = 0; i < x[0].size(); ++i) middle += (1 / n) * Vector<2>{x[0][i], x[1][i]};
    double sum = 0;
    for (std::size_t i = 0; i < x[0].size(); ++i)
        sum += square(x[0][i] - middle[0]) + square(x[1][i] - middle[1]);
    return std::sqrt(sum / n);
}

void wrap(const Box<2>& box, Columns<2>& x) {
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        Vector<2> inside{x[0][i], x[1][i]};
        box.wrap(inside);
        x[0][i] = inside[0], x[1][i] = inside[1];
    }
}

}  // namespace

double bond_order(const Columns<2>& x, const Box<2>& box) {
    double four = 0, six = 0;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        const auto seen = nearest_of(x, i, side_of(box), 6);
        four += folded(seen, 4), six += folded(seen, 6);
    }
    return std::max(four, six) / static_cast<double>(x[0].size());
}

CureRun run_cure(const CureScene& scene, const CureMethod& method) {
    const CureSetup setup = setup_of(scene);
    const auto liquid = cured(method, setup);
    const double side = setup.box.side(), count = static_cast<double>(setup.box.size());
    Columns<2>&x = liquid->get<Position>(), &v = liquid->get<Velocity>();
    for (std::size_t i = 0; i < liquid->size(); ++i)
        v[0][i] = scene.shear * std::sin(2 * pi * x[1][i] / side);
    liquid->resolve(0);
    Drifts drifts{*liquid};
    CureRun run;
    const double first_radius = radius(x);
    double t = 0;
    for (int s = 1; s <= samples; ++s) {
        const Marched done = march(*liquid, t, {.end = scene.time * s / samples});
        run.seconds += done.seconds, run.evaluations += 4 * done.steps;
        liquid->resolve(t);
        drifts.look();
        if (scene.progress) scene.progress(static_cast<double>(s) / samples);
    }
    run.momentum_drift = drifts.momentum() / count, run.energy_drift = drifts.energy() / count;
    run.radius = radius(x) / first_radius;
    run.x = x, run.v = v;
    wrap(setup.space(), run.x);
    run.smallest_distance = smallest_distance(run.x, setup.space());
    run.order = bond_order(run.x, setup.space());
    if (scene.shear > 0) run.kept_shear = shear_amplitude(run.x, v, side) / scene.shear;
    run.pairs = static_cast<double>(liquid->counters().pairs);
    return run;
}

report::Quantities CureRun::measured() const {
    return {{"smallest_distance", smallest_distance, "dx"},
            {"order", order},
            {"momentum_drift", momentum_drift, "c"},
            {"energy_drift", energy_drift, "c^2"}};
}

double CureRun::nanoseconds() const {
    return 1e9 * seconds / (static_cast<double>(evaluations) * static_cast<double>(x[0].size()));
}

report::Quantities CureRun::costs() const {
    return {{"nanoseconds_per_rate", nanoseconds(), "ns"},
            {"nanoseconds_per_pair", 1e9 * seconds / pairs, "ns"},  // of the near neighbours
            {"pairs", pairs},
            {"cpu_seconds", seconds, "s"}};
}

report::Quantities lattice_merits(const CureMethod& method, double pressure) {
    const Response response{method, pressure};
    return {{"growth", response.growth(), "c/dx"},
            {"sound_speed", response.sound_speed(), "c"},
            {"shear_speed", response.shear_speed(), "c"}};
}

CureCommand::CureCommand() : method_{cure_methods(), any_kernel_names(), {0.5, 5}} {}

void CureCommand::declare(app::CommandLine& line) {
    line.number("pressure", pressure_, {-0.8, 10}, "rho c^2", "at the lattice's density; below 0: tension")
        .number("jitter", jitter_, {0, 0.49}, "spacings", "largest random shift of each coordinate")
        .number("time", time_, {0, 1e5, true}, "dx/c", "how long the scene runs")
        .integer("particles", particles_, 8, 1000, "along each side");
    method_.declare(line);
}

void CureCommand::run(report::Run& run) const {
    if (method_.wants_list()) return run.print(cure_methods().text());
    const CureMethod method = method_.chosen();
    report::tell(run, method);
    CureScene scene;
    scene.n = static_cast<std::size_t>(particles_), scene.pressure = pressure_, scene.jitter = jitter_;
    scene.time = time_, scene.seed = run.seed(), scene.threads = run.threads();
    scene.progress = run.progress();
    run.record(method.name, scene.n, lattice_merits(method, pressure_));
    const CureRun cured = run_cure(scene, method);
    run.record(method.name, scene.n, cured.measured());
    run.record(method.name, scene.n, cured.costs());
    run.write("profile.csv",
              report::csv({{"x", cured.x[0]}, {"y", cured.x[1]}, {"v_x", cured.v[0]}, {"v_y", cured.v[1]}}));
    plot::Figure figure{"cure"};
    plot::Panel& panel = figure.panel().labels("$x$ / dx", "$y$ / dx").titled(method.label);
    panel.equal_aspect = true;
    panel.points(cured.x[0], cured.x[1], {.marker = plot::Marker::circle, .marker_size = 3});
    run.save(figure);
}

}  // namespace sph::tensile
