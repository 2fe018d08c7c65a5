#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"

#include <cmath>
#include <numbers>

#include "common/app/clock.hpp"
#include "common/exact/woodward_colella.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::shocks {
namespace {

/// Runs the grid to its end: the cells' averages as a profile, their widths, and what it took.
TubeRun advance(exact::FiniteVolume& grid, double time, double gamma, Column& width) {
    TubeRun run;
    run.seconds = app::thread_cpu_seconds([&] { grid.advance_to(time); });
    run.counters.steps = grid.steps();
    run.counters.pairs = grid.cell_updates();
    const IdealGas gas{gamma};
    const exact::GasCells cells = grid.cells();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& state = cells.states[i];
        run.whole.x.push_back(cells.centre(i));
        run.whole.rho.push_back(state.rho);
        run.whole.v.push_back(state.v);
        run.whole.p.push_back(state.p);
        run.whole.u.push_back(gas.energy(state.rho, state.p));
        width.push_back(cells.width(i));
    }
    return run;
}

}  // namespace

TubeRun run_grid_tube(const TubeScene& scene, exact::Frame frame) {
    const TubeProblem problem = gas_tube(scene);
    const auto [begin, end] = problem.ends;
    const double window = scene.window[1] - scene.window[0];
    const double per_length = static_cast<double>(scene.n) / window,
                 dx = window / static_cast<double>(scene.n);
    const double m = (scene.left.rho * (scene.diaphragm - scene.window[0]) +
                      scene.right.rho * (scene.window[1] - scene.diaphragm)) /
                     static_cast<double>(scene.n);
    const bool lagrangian = frame == exact::Frame::lagrangian;
    const auto count = [&](double length, double rho) {
        return static_cast<std::size_t>(std::ceil(lagrangian ? length * rho / m : length * per_length)) + 4;
    };
    const std::size_t left = count(-begin, scene.left.rho), right = count(end, scene.right.rho);
    exact::GasCells cells;
    const double left_width = lagrangian ? m / scene.left.rho : dx;
    const double right_width = lagrangian ? m / scene.right.rho : dx;
    for (std::size_t k = left; k > 0; --k) {
        cells.faces.push_back(scene.diaphragm - static_cast<double>(k) * left_width);
        cells.states.push_back(scene.left);
    }
    for (std::size_t k = 0; k <= right; ++k) {
        cells.faces.push_back(scene.diaphragm + static_cast<double>(k) * right_width);
        if (k < right) cells.states.push_back(scene.right);
    }
    exact::FiniteVolume grid{cells, {.gamma = scene.gamma, .frame = frame}};
    Column width;
    TubeRun run = advance(grid, scene.time, scene.gamma, width);
    compare(run, width, problem.exact);
    return run;
}

TubeRun run_grid_blast_waves(const BlastWaves& scene, exact::Frame frame) {
    constexpr double gamma = exact::WoodwardColella::gamma;
    exact::GasCells cells = exact::uniform_cells(0, 1, scene.n, {1, 0, 0.01});
    for (std::size_t i = 0; i < cells.size(); ++i) cells.states[i].p = blast_waves_pressure(cells.centre(i));
    exact::FiniteVolume grid{
        cells,
        {.gamma = gamma, .frame = frame, .left = exact::End::reflecting, .right = exact::End::reflecting}};
    Column width;
    TubeRun run = advance(grid, exact::WoodwardColella::time, gamma, width);
    compare_blast_waves(run, width);
    return run;
}

GridWave grid_standing_wave(std::size_t n, exact::Frame frame) {
    constexpr double gamma = 1.4, amplitude = 1e-6;
    const double begin = app::thread_cpu_seconds(), k = 2 * std::numbers::pi;
    exact::GasCells cells = exact::uniform_cells(0, 1, n, {1, 0, 1 / gamma});
    for (std::size_t i = 0; i < n; ++i) cells.states[i].v = amplitude * std::sin(k * cells.centre(i));
    exact::FiniteVolume grid{
        cells, {.gamma = gamma, .frame = frame, .left = exact::End::periodic, .right = exact::End::periodic}};
    double worst = 0;
    const auto looks = static_cast<int>(n);
    for (int look = 1; look <= looks; ++look) {
        const double t = static_cast<double>(look) / looks;
        grid.advance_to(t);
        const exact::GasCells now = grid.cells();
        double error = 0, size = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double shape = amplitude * std::sin(k * now.centre(i));
            error += std::abs(now.states[i].v - shape * std::cos(k * t));
            size += std::abs(shape);
        }
        worst = std::max(worst, error / size);
    }
    return {worst, app::thread_cpu_seconds() - begin};
}

const std::vector<Grid>& grids() {
    static const auto grid = [](const char* name, const char* label, exact::Frame frame) {
        return Grid{name, label, frame, plot::look_of(name, label)};
    };
    static const std::vector<Grid> all{grid("grid", "grid, Eulerian", exact::Frame::eulerian),
                                       grid("grid-lagrangian", "grid, Lagrangian", exact::Frame::lagrangian)};
    return all;
}

}  // namespace sph::shocks
