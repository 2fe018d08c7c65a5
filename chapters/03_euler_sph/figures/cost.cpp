#include "chapters/03_euler_sph/scenes/lagrangian_grid.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"
#include "common/exact/toy_star.hpp"
#include "common/report/norms.hpp"

/// What accuracy costs. Whole runs without their set-up: CPU seconds of one thread, the best of three.
namespace sph::euler {
namespace {

struct Measured {
    double error = 0, seconds = 0;
};

/// The wave on a Lagrangian grid: the same measure as run_wave.
Measured grid_wave(std::size_t n) {
    WaveScene scene;
    scene.n = n;
    LagrangianGrid<Polytrope> grid{scene.state(), 1, 0};
    for (std::size_t k = 0; k < n; ++k) {
        grid.x.push_back(static_cast<double>(k) * scene.spacing());
        grid.v.push_back(scene.velocity(grid.x.back(), 0));
        grid.m.push_back(scene.spacing());
    }
    const auto steps = static_cast<int>(std::ceil(1 / (scene.courant * scene.spacing())));
    double worst = 0;
    const double begin = report::thread_cpu_seconds();
    for (int step = 1; step <= steps; ++step) {
        grid.step(1.0 / steps);
        double error = 0, size = 0;
        for (std::size_t k = 0; k < n; ++k) {
            error += std::abs(grid.v[k] - scene.velocity(grid.x[k], static_cast<double>(step) / steps));
            size += std::abs(scene.velocity(grid.x[k], 0));
        }
        worst = std::max(worst, error / size);
    }
    return {worst, report::thread_cpu_seconds() - begin};
}

/// The faces of a star at rest on a grid with P = K rho^2 and cells of mass m: from the outermost face
/// inwards the pressure must carry what lies outside; where that face lies follows from symmetry, by
/// bisection.
std::vector<double> faces_at_rest(const Column& m, double K) {
    const std::size_t cells = m.size();
    std::vector<double> x(cells + 1);
    const auto inner_end = [&](double edge) {
        x[cells] = edge;
        double P = 0.5 * m[cells - 1] * edge;
        for (std::size_t k = cells; k-- > 0;) {
            x[k] = x[k + 1] - m[k] / std::sqrt(P / K);
            if (k > 0) P = std::max(P + 0.5 * (m[k] + m[k - 1]) * x[k], 1e-300);
        }
        return x[0];
    };
    double low = 0.5, high = 1.5;
    for (int step = 0; step < 80; ++step) {
        const double middle = (low + high) / 2;
        (inner_end(middle) < -middle ? low : high) = middle;
    }
    return x;
}

/// sqrt(<x^2>), with the mass of each cell in its middle.
double spread(const LagrangianGrid<Quadratic>& grid) {
    double moment = 0, mass = 0;
    for (std::size_t k = 0; k < grid.m.size(); ++k) {
        moment += grid.m[k] * square((grid.x[k] + grid.x[k + 1]) / 2);
        mass += grid.m[k];
    }
    return std::sqrt(moment / mass);
}

/// One period of the nonlinear star, gamma = 2, on a grid with the masses and the measures of run_nonlinear.
Measured grid_star(std::size_t n, double A_0) {
    StarScene scene;
    scene.n = n;
    const StarPoints points = star_points(scene);
    const exact::ToyStar star{2, scene.state().K, 1, A_0, 1, 1};
    LagrangianGrid<Quadratic> grid{{scene.state().K}, 0, 1};
    grid.m = points.m;
    grid.x = faces_at_rest(grid.m, scene.state().K);
    for (const double x : grid.x) grid.v.push_back(A_0 * x);
    double smallest = 1;
    for (int k = 0; k <= 1000; ++k) smallest = std::min(smallest, star.at(star.period() * k / 1000).radius);
    const double dt = 0.3 * points.width[n / 2] * std::sqrt(2.0) * std::pow(smallest, 1.5);
    const auto steps = static_cast<int>(std::ceil(star.period() / dt));
    plot::Values t, radius;
    const double begin = report::thread_cpu_seconds();
    for (int step = 1; step <= steps; ++step) {
        grid.step(star.period() / steps);
        if (step % std::max(1, steps / 100) != 0) continue;
        t.push_back(star.period() * step / steps);
        radius.push_back(std::sqrt(5.0) * spread(grid));
    }
    Measured measured{0, report::thread_cpu_seconds() - begin};
    for (std::size_t k = 0; k < t.size(); ++k)
        measured.error = std::max(measured.error, std::abs(radius[k] / star.at(t[k]).radius - 1));
    return measured;
}

struct Task {
    std::string name, label;
    plot::Style style;
    std::function<Measured(std::size_t)> measure;
};

/// Runs the tasks over the sizes, the last, which is the competitor, over larger ones too: a curve, rows of
/// results, and the seconds at which each reaches a bound. Returns how many times as long as the competitor
/// the last but one needs for the last bound.
double race(report::Run& run, plot::Panel& panel, const std::string& what, const std::vector<Task>& tasks,
            std::vector<std::size_t> sizes, const std::vector<double>& bounds, const std::string& text) {
    std::vector<std::string> header{"task"};
    for (const double bound : bounds) header.push_back("error ≤ " + report::number(bound, 1));
    report::Table table{header};
    plot::Values at_last_bound;
    for (const Task& task : tasks) {
        plot::Values seconds, error;
        std::vector<std::string> row{task.label};
        if (&task == &tasks.back() && !run.quick()) {
            for (const std::size_t more : {192UL, 288UL, 384UL}) sizes.push_back(more);
        }
        for (const std::size_t n : sizes) {
            Measured best = task.measure(n);
            for (int repeat = 1; repeat < (run.quick() || run.checking() ? 1 : 3); ++repeat)
                best.seconds = std::min(best.seconds, task.measure(n).seconds);
            seconds.push_back(best.seconds);
            error.push_back(best.error);
            run.result(what + " " + task.name, static_cast<long>(n), "error", best.error);
            run.result(what + " " + task.name, static_cast<long>(n), "cpu_seconds", best.seconds, "s");
        }
        at_last_bound.push_back(0);
        for (const double bound : bounds) {
            std::string cell = "–";
            for (std::size_t k = 0; k < sizes.size() && cell == "–"; ++k) {
                if (error[k] > bound) continue;
                cell = "N = " + std::to_string(sizes[k]) + ", " + report::timing(1e3 * seconds[k]) + " ms";
                if (bound == bounds.back()) at_last_bound.back() = seconds[k];
            }
            row.push_back(cell);
        }
        panel.curve(seconds, error, task.style);
        table.row(row);
    }
    run.fill(text, table.markdown());
    return at_last_bound[tasks.size() - 2] / at_last_bound.back();
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 1, 2};
    plot::Panel& waves_panel = figure.at(0, 1)
                                   .log_log()
                                   .titled("standing wave, one period")
                                   .labels("CPU time [s]", "relative $L$_{1} error of $v$");
    plot::Panel& stars_panel = figure.at(0, 0)
                                   .log_log()
                                   .titled("nonlinear star, one period")
                                   .labels("CPU time [s]", "relative error of the radius");
    const auto scheme_tasks = [](double best_h,
                                 const std::function<Measured(std::size_t, const GasScheme&)>& measure,
                                 bool constant_h) {
        std::vector<Task> tasks;
        for (const Named& named : compared_schemes(best_h)) {
            if (named.name == "fixed-h" && !constant_h) continue;     // it does not converge
            if (named.name == "averaged-h" && !constant_h) continue;  // has no star at rest to begin with
            tasks.push_back({named.name, named.label, named.style,
                             [measure, scheme = named.scheme](std::size_t n) { return measure(n, scheme); }});
        }
        return tasks;
    };
    const plot::Style grid{
        .label = "Lagrangian grid", .colour = plot::Colour{0, 0, 0}, .marker = plot::Marker::cross};
    auto waves = scheme_tasks(
        1.35,
        [](std::size_t n, const GasScheme& scheme) {
            WaveScene scene;
            scene.n = n;
            const WaveRun wave = run_wave(scene, scheme);
            return Measured{wave.error, wave.seconds};
        },
        true);
    waves.push_back({"grid", "Lagrangian grid", grid, grid_wave});
    const double wave_ratio = race(run, waves_panel, "wave", waves,
                                   run.quick() ? std::vector<std::size_t>{16, 32}
                                               : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128},
                                   {0.05, 0.01, 1e-3, 1e-4}, "cost-wave");
    const double A_0 = 1;
    auto stars = scheme_tasks(
        1.2,
        [A_0](std::size_t n, const GasScheme& scheme) {
            StarScene scene;
            scene.n = n;
            const exact::ToyStar star{2, scene.state().K, 1, A_0, 1, 1};
            const NonlinearRun swing = run_nonlinear(scene, scheme, A_0, star.period());
            return Measured{swing.radius_error, swing.seconds};
        },
        false);
    stars.push_back({"grid", "Lagrangian grid", grid, [A_0](std::size_t n) { return grid_star(n, A_0); }});
    const double star_ratio =
        race(run, stars_panel, "star", stars,
             run.quick() ? std::vector<std::size_t>{25, 50} : std::vector<std::size_t>{25, 35, 50, 75, 100},
             {0.01, 1e-3, 1e-4}, "cost-star");
    run.fill("cost-wave-ratio", report::timing(wave_ratio, 1));
    run.fill("cost-star-ratio", report::timing(star_ratio, 1));
    stars_panel.legend.shown = false;
    waves_panel.legend.outside = true;
    run.save(figure);
}

}  // namespace sph::euler
