#include "chapters/08_landau_model/scenes/grid.hpp"
#include "chapters/08_landau_model/figures/figures.hpp"
#include "common/report/norms.hpp"

/// What accuracy costs in the slab: error at t = 10 against particles and against CPU seconds.
namespace sph::landau {
namespace {

struct Series {
    std::string name, label;
    plot::Style style;
    std::vector<std::size_t> sizes;
    std::function<SlabProfile(std::size_t)> run;
};

std::vector<Series> all_series(report::Run& run) {
    const bool quick = run.quick();
    std::vector<Series> all;
    std::size_t k = 0;
    for (const char* name : {"variable", "graded", "narrow", "narrow-graded"}) {
        const SlabMethod method = slab_method(name);
        std::vector<std::size_t> sizes{30, 60, 125, 250, 500};
        if (method.name == slab_methods().back().name) sizes = {60, 125, 250, 500, 1000, 2000};
        if (quick) sizes = {60, 125};
        all.push_back({method.name,
                       method.label,
                       {.label = method.label, .colour = plot::cycle(k++), .marker = plot::Marker::circle},
                       sizes,
                       [method](std::size_t n) {
                           SlabScene scene{.n = n, .times = {10}, .courant = fast_courant};
                           return run_slab(scene, method).back();
                       }});
    }
    all.push_back(
        {"grid", "grid", grid_line(),
         quick ? std::vector<std::size_t>{50, 100} : std::vector<std::size_t>{50, 100, 200, 400, 800, 1600},
         [](std::size_t n) { return run_grid_slab(n, {10}).back(); }});
    return all;
}

}  // namespace

void slab_cost(report::Run& run) {
    plot::Figure figure{"slab-cost", 1, 2};
    plot::Panel& convergence =
        figure.at(0, 0).log_log().labels("particles or cells", "relative $L$_{1} error of $s$*, $t$ = 10");
    plot::Panel& cost = figure.at(0, 1).log_log().labels("CPU time [s]", "");
    convergence.legend.shown = false;
    cost.legend.outside = true;
    report::Table table{{"method", "N", "relative L1 of s*", "order", "steps", "CPU ms"}};
    for (const Series& series : all_series(run)) {
        plot::Values n, error, seconds;
        for (const std::size_t size : series.sizes) {
            const SlabProfile profile = series.run(size);
            const auto count = static_cast<long>(size);
            const std::string order =
                n.empty()
                    ? "–"
                    : report::fixed(report::observed_order(n.back(), error.back(), static_cast<double>(size),
                                                           profile.l1_s_star),
                                    1);
            n.push_back(static_cast<double>(size));
            error.push_back(profile.l1_s_star);
            seconds.push_back(profile.seconds);
            run.result(series.name, count, "l1_s_star", profile.l1_s_star);
            run.result(series.name, count, "steps", static_cast<double>(profile.counters.steps));
            run.result(series.name, count, "cpu_seconds", profile.seconds, "s");
            table.row({series.label, std::to_string(size), report::number(profile.l1_s_star, 2), order,
                       std::to_string(profile.counters.steps), report::timing(1e3 * profile.seconds)});
        }
        run.result(series.name, 0, "rate_l1_s_star", report::fitted_order(n, error));
        convergence.curve(n, error, series.style);
        cost.curve(seconds, error, series.style);
    }
    run.save(figure);
    run.fill("slab-cost", table.markdown());
}

}  // namespace sph::landau
