#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/05_tensile_instability/figures/kernel_looks.hpp"
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "chapters/05_tensile_instability/scenes/regularisation.hpp"

namespace sph::tensile {
namespace {

constexpr double P = 0.2;
constexpr int grid = 24;

double hexagonal_growth(const std::string& kernel, double h) {
    return growth_on_grid<2>(named_lattice<2>(kernel, h, hexagonal_lattice()), isotropic<2>(P), grid);
}
double square_growth(const std::string& kernel, double h) {
    return growth_on_grid<2>(named_lattice<2>(kernel, h), isotropic<2>(P), grid);
}
/// The h whose support has so many particles, pi (support h/dx)^2.
double h_of(const std::string& kernel, double neighbours) {
    return std::sqrt(neighbours / pi) / AnyKernel<2>{kernel}.support;
}

/// The largest growth with at least 15 and at most 120 neighbours, and its curve.
double draw_kernel(plot::Panel& panel, const std::string& kernel, int points) {
    plot::Values neighbours, rate;
    for (int n = 0; n <= points; ++n) {
        neighbours.push_back(15 + (120.0 - 15) * n / points);
        rate.push_back(hexagonal_growth(kernel, h_of(kernel, neighbours.back())));
    }
    panel.curve(neighbours, rate, plot::line(look_of_kernel(kernel, kernel)));
    return *std::max_element(rate.begin(), rate.end());
}

/// The smallest distances that jittered boxes of the cubic spline come to, with friction.
plot::Values nearest_pairs(report::Run& run, const plot::Values& h) {
    plot::Values nearest;
    for (const double one : h) {
        DisorderedBox scene{.friction = 0.1, .time = 150};
        scene.box.per_side = 16;
        scene.box.h_over_dx = one;
        scene.box.threads = run.threads();
        nearest.push_back(run_disorder(scene).nearest);
        run.record("cubic h/dx = " + report::number(one, 3), scene.box.per_side,
                   {{"nearest", nearest.back(), "dx"},
                    {"growth_hexagonal", hexagonal_growth("cubic", one), "c/dx"}});
    }
    return nearest;
}

}  // namespace

void pairing(report::Run& run) {
    plot::Figure figure{"pairing", 1, 2};
    plot::Panel& left = figure.at(0, 0)
                            .titled("hexagonal lattice, $P$ = 0.2")
                            .labels("neighbours in the support", "fastest growth / ($c$/d$x$)");
    const std::vector<std::string> kernels{"cubic", "quintic", "wendland-c2", "wendland-c4", "wendland-c6"};
    plot::Values most;
    for (const std::string& kernel : kernels) {
        most.push_back(draw_kernel(left, kernel, run.quick() ? 40 : 120));
        run.record(kernel, 1, {{"largest_growth_hexagonal", most.back(), "c/dx"}});
    }
    const double cubic = most[0], splines = std::min(most[0], most[1]), wendland_c2 = most[2],
                 high_order = std::max(most[3], most[4]);
    plot::Panel& right =
        figure.at(0, 1).titled("cubic spline, $P$ = 0.2").labels("$h$ / d$x$", "growth, and distance / d$x$");
    plot::Values h, square, hexagonal;
    for (int n = 0; n <= 70; ++n) {
        h.push_back(1 + 0.01 * n);
        square.push_back(square_growth("cubic", h.back()));
        hexagonal.push_back(hexagonal_growth("cubic", h.back()));
    }
    const plot::Values tried =
        run.quick() ? plot::Values{1.2, 1.3} : plot::Values{1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6};
    const plot::Values nearest = nearest_pairs(run, tried);
    right.curve(h, square,
                {.label = "growth, square lattice", .colour = plot::cycle(6), .dash = plot::Dash::dashed});
    right.curve(h, hexagonal, {.label = "growth, hexagonal lattice", .colour = plot::cycle(0)});
    right.points(tried, nearest,
                 {.label = "nearest pair, $t$ = 150 d$x$/$c$",
                  .colour = plot::cycle(1),
                  .marker = plot::Marker::circle});
    run.save(figure);
    const auto pairs_at = [&](double at) {
        return nearest[static_cast<std::size_t>(std::find(tried.begin(), tried.end(), at) - tried.begin())];
    };
    run.fill("pairing-at-1.3", report::fixed(hexagonal_growth("cubic", 1.3), 2));
    run.claim("pairing-wendland", [&] { return 10 * high_order < splines; });
    run.claim("pairing-c2", [&] { return wendland_c2 > splines && 3 * wendland_c2 < cubic; });
    run.claim(
        "pairing-begins",
        [&] { return hexagonal_growth("cubic", 1.1) == 0 && hexagonal_growth("cubic", 1.3) > 0.15; },
        report::Needs::any_run);
    run.fill("pairing-nearest", report::fixed(pairs_at(1.3), 1));
    run.claim("pairing-measured", [&] {
        for (std::size_t n = 0; n < tried.size(); ++n)
            if (tried[n] < 1.25 ? nearest[n] < 0.8 : nearest[n] > 0.5) return false;
        return true;
    });
}

}  // namespace sph::tensile
