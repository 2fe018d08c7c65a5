#include "chapters/03_euler_sph/scenes/disc.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"

namespace sph::euler {
namespace {

DiscScene scene_of(report::Run& run, DiscStart start) {
    DiscScene scene;
    scene.start = start;
    scene.seed = run.seed();
    scene.threads = run.threads();
    if (run.quick()) {
        scene.n = 300;
        scene.time = 10;
    }
    return scene;
}

Column radii(const Columns<2>& x) {
    Column r;
    for (std::size_t i = 0; i < x[0].size(); ++i) r.push_back(std::hypot(x[0][i], x[1][i]));
    return r;
}

plot::Style style_of(std::size_t k) {
    return {.label = k == 0 ? "equal masses" : "from a lattice",
            .colour = plot::cycle(k),
            .marker = k == 0 ? plot::Marker::circle : plot::Marker::square,
            .marker_size = 3};
}

/// Before and after, and the density (figures 1 and 2 of the review).
void draw_places(report::Run& run, const DiscRun& random, const DiscRun& lattice) {
    plot::Figure figure{"disc", 2, 2};
    const auto positions = [&](int row, int at, const std::string& title, const Columns<2>& x) {
        plot::Panel& panel = figure.at(row, at).titled(title).labels("$x$", "$y$");
        panel.x_range(-1.1, 1.1).y_range(-1.1, 1.1);
        panel.equal_aspect = true;
        panel.points(x[0], x[1],
                     {.colour = plot::cycle(0), .marker = plot::Marker::circle, .marker_size = 3});
    };
    positions(0, 0, "random places, equal masses", random.start_x);
    positions(0, 1, "the same, relaxed", random.x);
    positions(1, 0, "from a lattice, masses ~ ρ, relaxed", lattice.x);
    plot::Panel& density = figure.at(1, 1).titled("density").labels("$r$", "ρ");
    plot::Values r, rho;
    for (int k = 0; k <= 100; ++k) {
        r.push_back(k / 100.0);
        rho.push_back(1 - r.back() * r.back());
    }
    density.curve(r, rho, exact_line());
    density.points(radii(random.x), random.rho, style_of(0));
    density.points(radii(lattice.x), lattice.rho, style_of(1));
    run.save(figure);
}

/// A function and a slope on the relaxed particles (figures 3 and 4).
void draw_interpolated(report::Run& run, const std::array<DiscRun, 2>& stars) {
    plot::Figure figure{"disc-interpolation", 1, 2};
    plot::Panel& left = figure.at(0, 0).titled("$r$^{2} exp(−6$r$^{2}) by (2.8)").labels("$r$", "$A$");
    plot::Panel& right =
        figure.at(0, 1).titled("∂($r$^{2} − 1)/∂$x$ by (2.14), $r$ < 0.9").labels("$x$", "slope");
    plot::Values r, A;
    for (int k = 0; k <= 200; ++k) {
        r.push_back(k / 200.0);
        A.push_back(square(r.back()) * std::exp(-6 * square(r.back())));
    }
    left.curve(r, A, exact_line());
    right.curve({-1, 1}, {-2, 2}, exact_line());
    for (std::size_t k = 0; k < stars.size(); ++k) {
        const DiscRun& star = stars[k];
        const Column radius = radii(star.x);
        left.points(radius, star.function, style_of(k));
        plot::Values at, value;
        for (std::size_t i = 0; i < radius.size(); ++i) {
            if (radius[i] >= 0.9) continue;
            at.push_back(star.x[0][i]);
            value.push_back(star.gradient[i]);
        }
        right.points(at, value, style_of(k));
    }
    right.legend.shown = false;
    run.save(figure);
}

}  // namespace

void disc(report::Run& run) {
    const std::array stars{run_disc(scene_of(run, DiscStart::random_equal)),
                           run_disc(scene_of(run, DiscStart::lattice_varying))};
    draw_places(run, stars[0], stars[1]);
    draw_interpolated(run, stars);
    DiscScene wider = scene_of(run, DiscStart::random_equal);
    wider.sigma = 1.3;
    const DiscRun pairs = run_disc(wider);
    report::Table table{{"particles", "σ", "number", "nearest particle [spacings]", "ρ, relative L1 by mass",
                         "A, largest error / largest A", "slope, rms error", "before they moved"}};
    const auto report_on = [&](const std::string& method, const std::string& label, double sigma,
                               const DiscRun& star) {
        const auto n = static_cast<long>(star.m.size());
        run.result(method, n, "l1_rho", star.density_error);
        run.result(method, n, "linf_f", star.function_error);
        run.result(method, n, "rms_slope", star.gradient_error);
        run.result(method, n, "rms_slope_before", star.random_gradient_error);
        run.result(method, n, "nearest", star.nearest, "spacings");
        run.result(method, n, "rms_speed", star.speed);
        run.result(method, n, "momentum_drift", star.momentum);
        run.result(method, n, "steps", static_cast<double>(star.counters.steps));
        table.row({label, report::fixed(sigma, 1), report::fixed(static_cast<double>(n), 0),
                   report::fixed(star.nearest, 1), report::number(star.density_error, 1),
                   report::number(star.function_error, 1), report::number(star.gradient_error, 1),
                   report::number(star.random_gradient_error, 1)});
    };
    report_on("random", style_of(0).label, 1.1, stars[0]);
    report_on("lattice", style_of(1).label, 1.1, stars[1]);
    report_on("random sigma=1.3", style_of(0).label, 1.3, pairs);
    run.fill("disc", table.markdown());
}

}  // namespace sph::euler
