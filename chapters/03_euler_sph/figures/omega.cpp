#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/03_euler_sph/dispersion.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "common/plot/looks.hpp"

/// The grad-h factor: on an even line against h, and in a star.
namespace sph::euler {
namespace {

/// S of the Gaussian by Poisson's formula, its first alias only (Monaghan 2005, 5.10).
double gaussian_slope(double h) {
    return -square(2 * pi * h) * std::exp(-square(pi * h));
}

void on_a_line(report::Run& run, plot::Panel& panel) {
    plot::Values h, cubic, quintic, gaussian, formula;
    for (int k = 0; k <= 140; ++k) {
        h.push_back(0.6 + 0.01 * k);
        cubic.push_back(lattice_slope<CubicSpline<1>>(h.back()));
        quintic.push_back(lattice_slope<QuinticSpline<1>>(h.back()));
        gaussian.push_back(lattice_slope<Gaussian<1>>(h.back()));
        formula.push_back(gaussian_slope(h.back()));
    }
    panel.titled("even particles").labels("$h$/d$x$", "$S$");
    panel.x_range(0.6, 2).y_range(-0.1, 0.05);
    panel.curve(h, cubic, {.label = "cubic spline", .colour = plot::cycle(0)});
    panel.curve(h, quintic, {.label = "quintic spline", .colour = plot::cycle(2)});
    panel.curve(h, gaussian, {.label = "Gaussian", .colour = plot::cycle(1)});
    plot::Style dashed = plot::exact("its first alias");
    dashed.dash = plot::Dash::dashed;
    panel.curve(h, formula, dashed);
    const double usual = lattice_slope<CubicSpline<1>>(1.2);
    run.record("cubic", 1, {{"S_at_1.2", usual}, {"S_at_1.5", lattice_slope<CubicSpline<1>>(1.5)}});
    run.record("gaussian", 1, {{"S_at_1.2", lattice_slope<Gaussian<1>>(1.2)}});
    run.fill("s-usual", report::fixed(usual, 4));
    run.claim("s-is-small", [&] {
        bool gaussian_is_closer = true;
        for (std::size_t k = 60; k < h.size(); ++k)  // from h = 1.2 dx on
            gaussian_is_closer = gaussian_is_closer && std::abs(gaussian[k]) < 1e-4;
        return usual > 0.02 && usual < 0.021 && gaussian_is_closer;
    });
}

void in_a_star(report::Run& run, plot::Panel& panel) {
    StarScene scene;
    scene.n = 100;
    panel.titled("a star of 100").labels("$x$ / radius", "$Ω_{h}$").x_range(-1, 1);
    double largest = 0;
    for (const auto& [spacing, name, colour] :
         {std::tuple{Spacing::even, "even spacing", 0}, {Spacing::masses, "equal masses", 1}}) {
        scene.spacing = spacing;
        const GasMethod method{"consistent-h", "cubic", 1.2};
        const Column Omega = star_omega(scene, method);
        panel.points(star_points(scene).x, Omega,
                     {.label = name,
                      .colour = plot::cycle(static_cast<std::size_t>(colour)),
                      .marker = plot::Marker::circle,
                      .marker_size = 3});
        for (const double value : Omega) largest = std::max(largest, std::abs(value - 1));
    }
    run.record("star", scene.n, {{"largest_omega_minus_1", largest}});
    run.fill("omega-largest", report::number(100 * largest, 2));
    run.claim("omega-at-the-edge", [&] { return largest > 0.2; });
}

}  // namespace

void omega(report::Run& run) {
    plot::Figure figure{"omega", 1, 2};
    figure.panel_width = 330;
    on_a_line(run, figure.at(0, 0));
    in_a_star(run, figure.at(0, 1));
    run.save(figure);
}

}  // namespace sph::euler
