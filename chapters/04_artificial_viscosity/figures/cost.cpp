#include <cmath>
#include <functional>

#include "chapters/04_artificial_viscosity/scenes/grid_tube.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "chapters/04_artificial_viscosity/figures/figures.hpp"

/// What accuracy costs: the steps of whole runs, without set-up, in CPU seconds of one thread.
namespace sph::shocks {
namespace {

struct Point {
    double error = 0, seconds = 0;
};
struct Task {
    std::string name, label;
    plot::Style style;
    std::function<Point(std::size_t)> run;
};
struct Race {
    std::string name, title;
    std::vector<std::size_t> sizes;
    double error, seconds;  ///< of the tables "at equal error" and "at equal time"
};

/// log-log interpolation of y at x; 0 where x lies outside.
double interpolate(const plot::Values& x, const plot::Values& y, double at) {
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
        if ((x[k] - at) * (x[k + 1] - at) > 0) continue;
        const double share = std::log(at / x[k]) / std::log(x[k + 1] / x[k]);
        return y[k] * std::pow(y[k + 1] / y[k], share);
    }
    return 0;
}

std::string or_dash(double value, double factor = 1) {
    return value > 0 ? report::timing(factor * value) : "–";
}

/// Runs all tasks over all sizes; adds a curve each, and two cells to each row of the table.
void race(report::Run& run, plot::Panel& panel, const Race& what, const std::vector<Task>& tasks,
          std::vector<std::vector<std::string>>& rows) {
    constexpr double short_run = 0.02;  // seconds: below, the best of three
    for (std::size_t k = 0; k < tasks.size(); ++k) {
        plot::Values seconds, error;
        for (const std::size_t n : what.sizes) {
            Point best = tasks[k].run(n);
            const bool again = best.seconds < short_run && !run.quick() && !run.checking();
            for (int repeat = 0; repeat < (again ? 2 : 0); ++repeat)
                best.seconds = std::min(best.seconds, tasks[k].run(n).seconds);
            seconds.push_back(best.seconds);
            error.push_back(best.error);
            run.result(what.name + " " + tasks[k].name, static_cast<long>(n), "error", best.error);
            run.result(what.name + " " + tasks[k].name, static_cast<long>(n), "cpu_seconds", best.seconds,
                       "s");
        }
        panel.curve(seconds, error, tasks[k].style);
        rows[k].push_back(or_dash(interpolate(error, seconds, what.error), 1e3));
        rows[k].push_back(or_dash(interpolate(seconds, error, what.seconds), 100));
    }
}

Point point(const TubeRun& tube) {
    return {tube.l1_rho, tube.seconds};
}

/// The methods and both grids on one kind of tube.
std::vector<Task> tasks(const std::vector<std::string>& names,
                        const std::function<Point(const Method&, std::size_t)>& with_method,
                        const std::function<Point(exact::Frame, std::size_t)>& with_grid) {
    std::vector<Task> all;
    for (const Method& method : methods_named(names))
        all.push_back({method.name, method.label, style_of(method.name),
                       [with_method, method](std::size_t n) { return with_method(method, n); }});
    all.push_back(
        {"grid",
         "grid, Eulerian",
         {.label = "grid, Eulerian", .colour = plot::Colour{0, 0, 0}, .marker = plot::Marker::cross},
         [with_grid](std::size_t n) { return with_grid(exact::Frame::eulerian, n); }});
    all.push_back(
        {"grid-lagrangian",
         "grid, Lagrangian",
         {.label = "grid, Lagrangian", .colour = plot::Colour{0.5, 0.5, 0.5}, .marker = plot::Marker::plus},
         [with_grid](std::size_t n) { return with_grid(exact::Frame::lagrangian, n); }});
    return all;
}

Point grid_wave(exact::Frame frame, std::size_t n) {
    const double begin = report::thread_cpu_seconds();
    const double error = grid_standing_wave_error(n, frame);
    return {error, report::thread_cpu_seconds() - begin};
}

}  // namespace

void cost(report::Run& run) {
    std::vector<std::string> names;
    for (const Method& method : tube_methods()) {
        if (method.name != "none") names.push_back(method.name);
    }
    const auto tube = [](TubeScene scene) {
        return std::pair{[scene](const Method& method, std::size_t n) mutable {
                             scene.n = n;
                             return point(run_tube(scene, method));
                         },
                         [scene](exact::Frame frame, std::size_t n) mutable {
                             scene.n = n;
                             return point(run_grid_tube(scene, frame));
                         }};
    };
    const bool quick = run.quick();
    const auto sizes = [quick](std::vector<std::size_t> full) {
        return quick ? std::vector<std::size_t>{full[0], full[1]} : full;
    };
    plot::Figure figure{"cost", 2, 2};
    std::vector<std::vector<std::string>> rows;
    for (const Method& method : methods_named(names)) rows.push_back({method.label});
    rows.push_back({"grid, Eulerian"});
    rows.push_back({"grid, Lagrangian"});
    const auto panel = [&](int row, int column, const Race& what, const std::vector<Task>& all) {
        plot::Panel& axes =
            figure.at(row, column)
                .log_log()
                .titled(what.title)
                .labels("CPU time [s]", row == 1 && column == 1 ? "relative $L$_{1} error of $v$"
                                                                : "relative $L$_{1} error of ρ");
        axes.legend.shown = row == 0 && column == 1;
        axes.legend.outside = true;
        race(run, axes, what, all, rows);
    };
    const auto [sod, grid_sod] = tube({});
    panel(0, 0, {"sod", "Sod", sizes({45, 90, 180, 360, 540}), 0.01, 0.01}, tasks(names, sod, grid_sod));
    const auto [blast, grid_blast] = tube({{1, 0, 3000}, {1, 0, 1e-7}, 5.0 / 3, 0.006});
    panel(0, 1, {"blast", "blast", sizes({50, 75, 100, 150, 200}), 0.04, 0.02},
          tasks(names, blast, grid_blast));
    panel(
        1, 0, {"woodward-colella", "Woodward–Colella", sizes({50, 75, 100, 150, 200}), 0.15, 0.05},
        tasks(
            names,
            [](const Method& method, std::size_t n) { return point(run_blast_waves({.n = n}, method)); },
            [](exact::Frame frame, std::size_t n) { return point(run_grid_blast_waves({.n = n}, frame)); }));
    panel(1, 1, {"wave", "standing wave", sizes({16, 32, 64, 96, 128}), 0.01, 0.001},
          tasks(
              names,
              [](const Method& method, std::size_t n) {
                  const StandingWaveRun wave = run_standing_wave({.n = n}, method);
                  return Point{wave.error, wave.seconds};
              },
              grid_wave));
    run.save(figure);
    report::Table table{{"method", "Sod: ms to ρ 1 %", "ρ % in 10 ms", "blast: ms to ρ 4 %", "ρ % in 20 ms",
                         "W–C: ms to ρ 15 %", "ρ % in 50 ms", "wave: ms to v 1 %", "v % in 1 ms"}};
    for (const auto& row : rows) table.row(row);
    run.fill("cost", table.markdown());
}

}  // namespace sph::shocks
