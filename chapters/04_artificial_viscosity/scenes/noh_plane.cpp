#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"

#include <cmath>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/app/clock.hpp"
#include "common/exact/finite_volume_2d.hpp"
#include "common/exact/noh.hpp"

namespace sph::shocks {
namespace {

std::unique_ptr<Simulation<2>> make_disc(const NohScene& scene, const Method<2>& method) {
    const double end = scene.radius, begin = scene.quarter ? 0 : -end;
    const Placed placed =
        make_lattice(scene.lattice, {begin, begin}, {end, end}, static_cast<double>(scene.n) / scene.radius);
    std::vector<Vector<2>> x;
    for (std::size_t i = 0; i < placed.x[0].size(); ++i) {
        if (std::hypot(placed.x[0][i], placed.x[1][i]) < scene.radius)
            x.push_back({placed.x[0][i], placed.x[1][i]});
    }
    const Face inner = scene.quarter ? Face::mirror : Face::free;
    auto gas =
        method.make({.n = x.size(),
                     .state = IdealGas{scene.gamma},
                     .box = Box<2>{{begin, begin}, {end, end}, {{{inner, Face::free}, {inner, Face::free}}}},
                     .courant = scene.courant,
                     .threads = scene.threads});
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double r = std::hypot(x[i][0], x[i][1]);
        const Vector<2> v{r > 0 ? -x[i][0] / r : 0, r > 0 ? -x[i][1] / r : 0};
        gas->place(i, x[i], v, placed.spacing * placed.spacing, 1, scene.pressure);
    }
    gas->start(0);
    gas->resolve(0);
    return gas;
}

/// Errors, means and the shock's place of what a run has left in x, v, m, rho, with that spacing at the
/// start.
void measure(NohRun& run, const NohScene& scene, double spacing) {
    run.r = radii(run.x), run.v_r = radial(run.x, run.v);
    const exact::Noh noh{2, scene.gamma, 1, 1};
    const double R = noh.shock_position(scene.time), end = 0.9 * (scene.radius - scene.time);
    double rho_error = 0, rho_sum = 0, v_error = 0, v_sum = 0, mass = 0, area = 0, inner_mass = 0,
           inner_area = 0;
    for (std::size_t i = 0; i < run.r.size(); ++i) {
        const double r = run.r[i], dA = run.m[i] / run.rho[i];
        if (r >= end) continue;
        const auto exact = noh.at(r, scene.time);
        rho_error += dA * std::abs(run.rho[i] - exact.rho);
        rho_sum += dA * exact.rho;
        v_error += dA * std::abs(run.v_r[i] - exact.v);
        v_sum += dA * std::abs(exact.v);
        if (r < 0.1 * R) inner_mass += run.m[i], inner_area += dA;
        if (r > 0.25 * R && r < 0.75 * R) mass += run.m[i], area += dA;
    }
    run.l1_rho = rho_error / rho_sum;
    run.l1_v = v_error / v_sum;
    run.plateau = area > 0 ? mass / area : 0;
    run.centre = inner_area > 0 ? inner_mass / inner_area : 0;
    double squares = 0;
    for (std::size_t i = 0; i < run.r.size(); ++i) {
        if (run.r[i] > 0.25 * R && run.r[i] < 0.75 * R)
            squares += run.m[i] / run.rho[i] * square(run.rho[i] / run.plateau - 1);
    }
    run.scatter = area > 0 ? std::sqrt(squares / area) : 0;
    run.shock =
        outermost_rise(ring_means(run.r, run.rho, run.m, 0.5 * spacing, end), noh.post_shock().rho / 2);
}

}  // namespace

NohRun run_noh(const NohScene& scene, const Method<2>& method) {
    if (!(scene.radius > scene.time)) throw std::invalid_argument{"the gas must be larger than it moves"};
    require_lattice(scene.lattice, scene.quarter);
    const auto gas = make_disc(scene, method);
    Drifts drifts{*gas};
    double t = 0;
    NohRun run;
    run.seconds = march(*gas, t, {.end = scene.time, .most_steps = scene.most_steps}).seconds;
    gas->resolve(t);
    drifts.look();
    run.x = gas->get<Position>(), run.v = gas->get<Velocity>();
    run.m = gas->get<Mass>(), run.rho = gas->get<Density>();
    run.energy_drift = drifts.energy() / drifts.first().energy;
    if (!scene.quarter) run.momentum_drift = drifts.momentum() / drifts.first().mass;
    run.counters = gas->counters();
    measure(run, scene, scene.radius / static_cast<double>(scene.n));
    return run;
}

NohRun run_noh_grid(const NohScene& scene, std::size_t n) {
    const exact::Noh noh{2, scene.gamma, 1, 1};
    const auto inflow = [&](double x, double y, double t) {
        const double r = std::hypot(x, y);
        return exact::GasState2D{t > 0 ? noh.at(r, t).rho : 1, -x / r, -y / r, scene.pressure};
    };
    const double side = scene.radius;
    exact::GasGrid grid{0, side, 0, side, n, n, {}};
    grid.fill([&](double x, double y) { return inflow(x, y, 0); });
    exact::FiniteVolume2D solver{grid,
                                 {.gamma = scene.gamma,
                                  .left = exact::End::reflecting,
                                  .right = exact::End::inflow,
                                  .bottom = exact::End::reflecting,
                                  .top = exact::End::inflow,
                                  .inflow = inflow}};
    NohRun run;
    run.seconds = app::thread_cpu_seconds([&] { solver.advance_to(scene.time); });
    run.counters.steps = solver.steps();
    const GridColumns columns = columns_of(solver.cells());
    run.x = columns.x, run.v = columns.v, run.m = columns.m, run.rho = columns.rho;
    measure(run, scene, grid.dx());
    return run;
}

report::Quantities NohRun::measured() const {
    return {{"l1_rho", l1_rho},
            {"l1_v", l1_v},
            {"plateau", plateau},
            {"centre", centre},
            {"scatter", scatter},
            {"shock", shock},
            {"steps", static_cast<double>(counters.steps)},
            {"cpu_seconds", seconds, "s"}};
}

}  // namespace sph::shocks
