#include "chapters/07_godunov_sph/scenes/sedov.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"
#include "common/app/error.hpp"
#include "common/exact/sedov.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::godunov {
namespace {

constexpr double side = 0.5, measured_to = 0.9 * side;

/// Points of a cubic lattice, n in the side.
template <int d>
std::vector<Vector<d>> lattice(std::size_t n) {
    std::size_t count = 1;
    for (int a = 0; a < d; ++a) count *= n;
    std::vector<Vector<d>> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t rest = i;
        for (double& component : points[i]) {
            component = (static_cast<double>(rest % n) + 0.5) * side / static_cast<double>(n);
            rest /= n;
        }
    }
    return points;
}

template <int d>
std::unique_ptr<Simulation<d>> make_gas(const BlastScene& scene, const shocks::Method<d>& method) {
    const auto points = lattice<d>(scene.n);
    const double spacing = side / static_cast<double>(scene.n), m = std::pow(spacing, d);
    Vector<d> low{}, high{};
    for (double& component : high) component = side;
    auto gas = method.make({.n = points.size(),
                            .state = IdealGas{scene.gamma},
                            .box = Box<d>{low, high, Face::mirror},
                            .courant = scene.courant,
                            .threads = scene.threads});
    Column shape;
    double sum = 0;
    for (const Vector<d>& x : points) {
        shape.push_back(CubicSpline<d>::W(std::sqrt(dot(x, x)), scene.blast_width * spacing));
        sum += m * shape.back();
    }
    const double energy = std::pow(0.5, d);  // of the part between the mirrors
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double p = IdealGas{scene.gamma}.pressure(1, shape[i] * energy / sum);
        gas->place(i, points[i], {}, m, 1, scene.pressure + p);
    }
    gas->start(0);
    gas->resolve(0);
    return gas;
}

template <int d>
void measure(BlastRun<d>& run, const BlastScene& scene, const Columns<d>& v) {
    const exact::Sedov blast{d, scene.gamma, 1, 1};
    double errors[3] = {}, sums[3] = {};
    for (std::size_t i = 0; i < run.m.size(); ++i) {
        double r2 = 0, along = 0;
        for (std::size_t a = 0; a < d; ++a) r2 += square(run.x[a][i]), along += run.x[a][i] * v[a][i];
        const double r = std::sqrt(r2);
        run.r.push_back(r), run.v_r.push_back(r > 0 ? along / r : 0);
        if (r >= measured_to) continue;
        const auto exact = blast.at(r, run.time);
        const double volume = run.m[i] / run.rho[i];
        const double value[3] = {run.rho[i], run.v_r[i], run.p[i]}, at[3] = {exact.rho, exact.v, exact.p};
        for (std::size_t k = 0; k < 3; ++k) {
            errors[k] += volume * std::abs(value[k] - at[k]);
            sums[k] += volume * at[k];
        }
    }
    run.l1_rho = errors[0] / sums[0], run.l1_v = errors[1] / sums[1], run.l1_p = errors[2] / sums[2];
    const auto shells =
        shocks::ring_means(run.r, run.rho, run.m, 0.5 * side / static_cast<double>(scene.n), measured_to);
    const double peak = *std::max_element(shells.value.begin(), shells.value.end());
    run.peak = peak / blast.post_shock(run.time).rho;
    run.shock = shocks::outermost_rise(shells, 1 + (peak - 1) / 2);
}

}  // namespace

template <int d>
BlastRun<d> run_blast(const BlastScene& scene, const shocks::Method<d>& method) {
    const exact::Sedov blast{d, scene.gamma, 1, 1};
    const auto gas = make_gas<d>(scene, method);
    Drifts drifts{*gas};
    BlastRun<d> run;
    run.time = std::sqrt(blast.alpha() * std::pow(scene.radius, d + 2));
    double t = 0;
    run.seconds = march(*gas, t, {.end = run.time, .most_steps = scene.most_steps}).seconds;
    gas->resolve(t);
    drifts.look();
    run.x = gas->template get<Position>(), run.m = gas->template get<Mass>();
    run.rho = gas->template get<Density>(), run.p = gas->template get<Pressure>();
    run.energy_drift = drifts.energy() / drifts.first().energy;
    run.counters = gas->counters();
    measure<d>(run, scene, gas->template get<Velocity>());
    return run;
}
template BlastRun<1> run_blast<1>(const BlastScene&, const shocks::Method<1>&);
template BlastRun<2> run_blast<2>(const BlastScene&, const shocks::Method<2>&);
template BlastRun<3> run_blast<3>(const BlastScene&, const shocks::Method<3>&);

template <int d>
report::Quantities BlastRun<d>::measured() const {
    return {{"l1_rho", l1_rho},           {"l1_v", l1_v}, {"l1_p", l1_p},
            {"shock_radius", shock},      {"peak", peak}, {"steps", static_cast<double>(counters.steps)},
            {"cpu_seconds", seconds, "s"}};
}
template struct BlastRun<1>;
template struct BlastRun<2>;
template struct BlastRun<3>;

void SedovInSpace::declare(app::CommandLine& line) {
    line.integer("dimension", dimension_, 1, 3, "of space")
        .integer("particles", particles_, 8, 200, "in the side 0.5 of the part between mirrors")
        .number("gamma", gamma_, {1.05, 3}, "", "adiabatic index")
        .text("method", method_, "NAME", "'list' names those of the dimension");
}

template <int d>
void SedovInSpace::run_in(report::Run& run, const shocks::Methods<d>& methods) const {
    if (method_ == "list") return run.print(methods.text());
    const auto names = methods.names();
    if (std::find(names.begin(), names.end(), method_) == names.end())
        throw app::UsageError{"--method: " + method_ + " is not allowed with --dimension " +
                              std::to_string(d) + "; allowed: list, " + app::option_text::joined(names)};
    const shocks::Method<d>& method = methods[method_];
    report::tell(run, method);
    const BlastScene scene{
        .gamma = gamma_, .n = static_cast<std::size_t>(particles_), .threads = run.threads()};
    const BlastRun<d> blast = run_blast<d>(scene, method);
    run.record(method.name, blast.m.size(),
               blast.measured() + report::Quantities{{"energy_drift", blast.energy_drift}});
    run.write("profile.csv",
              report::csv({{"r", blast.r}, {"rho", blast.rho}, {"v", blast.v_r}, {"p", blast.p}}));
    plot::Figure figure{"sedov", 1, 1};
    plot::Panel& panel = figure.at(0, 0).labels("$r$", "ρ").x_range(0, side);
    panel.points(blast.r, blast.rho, plot::dots(method.styled(), 2));
    const exact::Sedov exact{d, gamma_, 1, 1};
    plot::draw_exact(panel, 0, side, [&](double r) { return exact.at(r, blast.time).rho; });
    run.save(figure);
}

void SedovInSpace::run(report::Run& run) const {
    if (dimension_ == 1) return run_in<1>(run, line_methods());
    if (dimension_ == 2) return run_in<2>(run, plane_methods());
    run_in<3>(run, space_methods());
}

}  // namespace sph::godunov
