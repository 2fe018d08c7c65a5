#include "chapters/03_euler_sph/scenes/disc.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

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
    plot::draw_exact(density, 0, 1, [](double r) { return 1 - r * r; });
    density.points(radii(random.x), random.rho, style_of(0));
    density.points(radii(lattice.x), lattice.rho, style_of(1));
    run.save(figure);
}

/// A function and a slope on the relaxed particles (figures 3 and 4).
void draw_interpolated(report::Run& run, const std::array<DiscRun, 2>& stars) {
    plot::Figure figure{"disc-interpolation", 1, 2};
    plot::Panel& left = figure.at(0, 0).titled("$r$^{2} exp(−6$r$^{2}) by (1.3)").labels("$r$", "$A$");
    plot::Panel& right =
        figure.at(0, 1).titled("∂($r$^{2} − 1)/∂$x$ by (1.12), $r$ < 0.9").labels("$x$", "slope");
    plot::draw_exact(left, 0, 1, [](double r) { return r * r * std::exp(-6 * r * r); });
    right.curve({-1, 1}, {-2, 2}, plot::exact());
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
    wider.h_over_dx = 1.3;
    const DiscRun pairs = run_disc(wider);
    using namespace report;
    Comparison table{{"particles", "h/dx", "number"},
                     {{"nearest particle [spacings]", "nearest", decimals(1)},
                      {"ρ, relative L1 by mass", "l1_rho", digits(1)},
                      {"A, largest error / largest A", "linf_f", digits(1)},
                      {"slope, rms error", "rms_slope", digits(1)},
                      {"before they moved", "rms_slope_before", digits(1)}}};
    const auto add = [&](const std::string& method, const std::string& label, double sigma,
                         const DiscRun& star) {
        table.add(run, method, star.m.size(), {label, fixed(sigma, 1), std::to_string(star.m.size())},
                  star.measured());
    };
    add("random", style_of(0).label, 1.1, stars[0]);
    add("lattice", style_of(1).label, 1.1, stars[1]);
    add("random sigma=1.3", style_of(0).label, 1.3, pairs);
    run.fill("disc", table.markdown());
    run.claim("disc-orders-itself", [&] {
        return stars[0].nearest > 0.9 && stars[0].gradient_error < stars[0].random_gradient_error / 3;
    });
    run.claim("lattice-gets-worse",
              [&] { return stars[1].gradient_error > 3 * stars[1].random_gradient_error; });
    run.claim("disc-pairs", [&] {
        return pairs.nearest < 0.5 && pairs.gradient_error > 1.5 * stars[0].gradient_error &&
               pairs.density_error < 1.2 * stars[0].density_error;
    });
}

}  // namespace sph::euler
