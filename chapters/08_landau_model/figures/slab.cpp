#include <cmath>

#include "chapters/08_landau_model/figures/figures.hpp"
#include "common/exact/landau.hpp"

/// Profiles of the slab by the recommended method, and its edge by several.
namespace sph::landau {
namespace {

struct Line {
    plot::Values x, s_star, eps, rapidity;
};
/// The exact solution in 0 <= x < 1 + t, dense towards the edge.
Line exact_line_of(double t) {
    constexpr int points = 801;
    const exact::LandauSlab solution{t};
    Line line;
    for (int k = 0; k < points; ++k) {
        const double gap = std::pow(1 - static_cast<double>(k) / (points - 1), 3);
        const double x = solution.edge() * (1 - std::max(gap, 1e-9));
        const auto at = solution.at(x);
        line.x.push_back(x), line.s_star.push_back(at.s_star);
        line.eps.push_back(at.eps), line.rapidity.push_back(at.rapidity);
    }
    return line;
}

/// The particles with x >= 0, every `stride`-th.
plot::Values right_half(const SlabProfile& profile, const Column& value, std::size_t stride) {
    plot::Values half;
    for (std::size_t i = profile.x.size() / 2; i < profile.x.size(); i += stride) half.push_back(value[i]);
    return half;
}

std::string at_time(double t) {
    return "$t$ = " + report::number(t, 3);
}

/// Three panels over x >= 0 at the given times.
void profiles(report::Run& run, const std::string& name, const std::vector<double>& times) {
    const SlabMethod& method = slab_methods().back();
    SlabScene scene;
    scene.n = run.quick() ? 200 : 1000;
    scene.times = times;
    scene.courant = fast_courant;
    const std::size_t stride = scene.n / 100;
    plot::Figure figure{name, 2, 2};
    plot::Panel& s_star = figure.at(0, 0).labels("$x$", "$s$*");
    plot::Panel& rapidity = figure.at(0, 1).labels("$x$", "rapidity").y_range(0, 6);
    plot::Panel& eps = figure.at(1, 0).labels("$x$", "ε/ε_{0}").log_y().y_range(1e-6, 2);
    plot::Panel& error = figure.at(1, 1).labels("$x$/(1 + $t$)", "$s$*/$s$*_{exact} – 1");
    rapidity.legend.shown = eps.legend.shown = error.legend.shown = false;
    report::Table table{
        {"t", "relative L1 of s*", "energy drift", "momentum", "last particle to edge", "steps"}};
    std::size_t k = 0;
    double last_error = 0;
    for (const SlabProfile& profile : run_slab(scene, method)) {
        const Line exact = exact_line_of(profile.time);
        const plot::Values x = right_half(profile, profile.x, stride);
        const auto both = [&](plot::Panel& panel, const plot::Values& line, const Column& value) {
            panel.curve(exact.x, line, {.colour = plot::Colour{0, 0, 0}, .width = 1});
            panel.points(x, right_half(profile, value, stride),
                         {.label = at_time(profile.time),
                          .colour = plot::cycle(k),
                          .marker = plot::Marker::circle,
                          .marker_size = 3.5});
        };
        both(s_star, exact.s_star, profile.s_star);
        both(rapidity, exact.rapidity, profile.rapidity);
        both(eps, exact.eps, profile.eps);
        plot::Values place, relative;
        for (std::size_t i = scene.n / 2; i < scene.n; ++i) {
            place.push_back(profile.x[i] / (1 + profile.time));
            relative.push_back(profile.s_star[i] / profile.exact_s_star[i] - 1);
        }
        error.curve(place, relative, {.label = at_time(profile.time), .colour = plot::cycle(k)});
        ++k;
        last_error = profile.l1_s_star;
        const auto n = static_cast<long>(scene.n);
        const std::string row = method.name + " t=" + report::number(profile.time, 3);
        run.result(row, n, "l1_s_star", profile.l1_s_star);
        run.result(row, n, "energy_drift", profile.energy_drift);
        run.result(row, n, "momentum_drift", profile.momentum);
        table.row({report::number(profile.time, 3), report::number(profile.l1_s_star, 2),
                   below(profile.energy_drift), below(10 * std::max(std::abs(profile.momentum), 1e-16)),
                   report::number(profile.edge_gap, 2), std::to_string(profile.counters.steps)});
    }
    error.y_range(-0.02, 0.02);
    run.save(figure);
    run.fill(name, table.markdown());
    if (name == "slab") run.fill("answer-slab", report::number(last_error, 2));
}

}  // namespace

void early(report::Run& run) {
    profiles(run, "early", {0.25, 0.5, 1, 1.5});
}
void slab(report::Run& run) {
    profiles(run, "slab", {2, 4, 6, 8, 10});
}

void edge(report::Run& run) {
    SlabScene scene;
    scene.n = run.quick() ? 120 : 500;
    scene.times = {2, 10};
    scene.courant = fast_courant;
    plot::Figure figure{"edge", 1, 2};
    std::vector<std::vector<SlabProfile>> runs;
    const std::vector<std::string> names{"fixed-20", "variable", "narrow", "narrow-graded"};
    for (const std::string& name : names) runs.push_back(run_slab(scene, slab_method(name)));
    for (std::size_t panel = 0; panel < 2; ++panel) {
        const double t = scene.times[panel];
        plot::Panel& axes = figure.at(0, static_cast<int>(panel))
                                .titled(at_time(t))
                                .labels("1 + $t$ – $x$", "$s$*")
                                .log_log()
                                .x_range(2e-4, 1);
        const exact::LandauSlab solution{t};
        plot::Values gap, s_star;
        for (double g = 2e-4; g < 1; g *= 1.05) {
            gap.push_back(g), s_star.push_back(solution.at(solution.edge() - g).s_star);
        }
        axes.curve(gap, s_star, exact_line());
        for (std::size_t k = 0; k < names.size(); ++k) {
            const SlabProfile& profile = runs[k][panel];
            plot::Values x, y;
            for (std::size_t i = scene.n / 2; i < scene.n; ++i) {
                const double g = solution.edge() - profile.x[i];
                if (g < 2e-4 || g > 1) continue;
                x.push_back(g), y.push_back(profile.s_star[i]);
            }
            axes.points(x, y,
                        {.label = slab_method(names[k]).label,
                         .colour = plot::cycle(k),
                         .marker = plot::Marker::circle,
                         .marker_size = 3});
        }
        axes.legend.shown = panel == 1;
    }
    run.save(figure);
}

}  // namespace sph::landau
