#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"

#include <cmath>
#include <stdexcept>

#include "common/core/unstable.hpp"
#include "common/exact/finite_volume_2d.hpp"
#include "common/exact/noh.hpp"
#include "common/report/timer.hpp"

namespace sph {
namespace {

std::unique_ptr<Model<2>> make_disc(const NohScene& scene, const Method& method) {
    const double end = scene.radius, begin = scene.quarter ? 0 : -end;
    const Placed placed =
        make_lattice(scene.lattice, {begin, begin}, {end, end}, static_cast<double>(scene.n) / scene.radius);
    Columns<2> x;
    for (std::size_t i = 0; i < placed.x[0].size(); ++i) {
        if (std::hypot(placed.x[0][i], placed.x[1][i]) >= scene.radius) continue;
        for (std::size_t a = 0; a < 2; ++a) x[a].push_back(placed.x[a][i]);
    }
    const Face inner = scene.quarter ? Face::mirror : Face::free;
    const Box<2> box{{begin, begin}, {end, end}, {{{inner, Face::free}, {inner, Face::free}}}};
    auto gas = make_model(method, x[0].size(), scene.gamma, box, scene.threads);
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        const double r = std::hypot(x[0][i], x[1][i]);
        const Vector<2> v{r > 0 ? -x[0][i] / r : 0, r > 0 ? -x[1][i] / r : 0};
        gas->set(i, {x[0][i], x[1][i]}, v, placed.spacing * placed.spacing, 1,
                 scene.pressure / (scene.gamma - 1));
    }
    return gas;
}

/// Errors and means of what a run has left in r, m, rho, v_r.
void measure(NohRun& run, const NohScene& scene) {
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
            squares += run.m[i] / run.rho[i] * std::pow(run.rho[i] / run.plateau - 1, 2);
    }
    run.scatter = area > 0 ? std::sqrt(squares / area) : 0;
}

}  // namespace

NohRun run_noh(const NohScene& scene, const Method& method) {
    if (!(scene.radius > scene.time)) throw std::invalid_argument{"the gas must be larger than it moves"};
    if (scene.quarter && scene.lattice != Lattice::square)
        throw std::invalid_argument{"only the square lattice is its own mirror image"};
    const double begin = report::thread_cpu_seconds();
    const auto gas = make_disc(scene, method);
    gas->resolve(0);
    const double energy = gas->energy();
    double t = 0, mass = 0;
    gas->advance(t, scene.time, scene.courant,
                 [&](double now) { require_fewer_steps(*gas, scene.most_steps, now); });
    NohRun run;
    run.seconds = report::thread_cpu_seconds() - begin;
    run.x = gas->x(), run.v = gas->v();
    run.m = gas->m(), run.rho = gas->rho();
    run.r = radii(run.x), run.v_r = radial(run.x, run.v);
    for (const double m : run.m) mass += m;
    run.energy_drift = std::abs(gas->energy() / energy - 1);
    if (!scene.quarter) {  // which began with 0 but for the lattice's rounding
        for (const double component : gas->momentum())
            run.momentum_drift = std::max(run.momentum_drift, std::abs(component) / mass);
    }
    run.counters = gas->counters();
    measure(run, scene);
    return run;
}

NohRun run_noh_grid(const NohScene& scene, std::size_t n) {
    const double begin = report::thread_cpu_seconds();
    const exact::Noh noh{2, scene.gamma, 1, 1};
    const auto inflow = [&](double x, double y, double t) {
        const double r = std::hypot(x, y);
        return exact::GasState2D{t > 0 ? noh.at(r, t).rho : 1, -x / r, -y / r, scene.pressure};
    };
    const double side = scene.radius - scene.time;
    exact::GasGrid grid{0, side, 0, side, n, n, {}};
    grid.fill([&](double x, double y) { return inflow(x, y, 0); });
    exact::FiniteVolume2D solver{grid,
                                 {.gamma = scene.gamma,
                                  .left = exact::End::reflecting,
                                  .right = exact::End::inflow,
                                  .bottom = exact::End::reflecting,
                                  .top = exact::End::inflow,
                                  .inflow = inflow}};
    solver.advance_to(scene.time);
    NohRun run;
    run.seconds = report::thread_cpu_seconds() - begin;
    const exact::GasGrid cells = solver.cells();
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            const auto& cell = cells.at(i, j);
            run.x[0].push_back(cells.x(i)), run.x[1].push_back(cells.y(j));
            run.v[0].push_back(cell.vx), run.v[1].push_back(cell.vy);
            run.rho.push_back(cell.rho);
            run.m.push_back(cell.rho * cells.dx() * cells.dy());
        }
    }
    run.r = radii(run.x), run.v_r = radial(run.x, run.v);
    run.counters.steps = solver.steps();
    measure(run, scene);
    return run;
}

}  // namespace sph
