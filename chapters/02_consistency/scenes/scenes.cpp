#include <cstdio>

#include "chapters/02_consistency/figures/figures.hpp"
#include "common/app/error.hpp"

/// Scenes of the reader's own: `run 02 --scene NAME` with the chapter's options.
namespace sph::consistency {
namespace {

template <int d>
Function<d> function_named(const std::string& name) {
    if (name == "two-gaussians") return sph::two_gaussians<d>();
    if (name == "constant") return polynomial<d>(1, 0, 0);
    if (name == "line") return polynomial<d>(0.5, 1, 0);
    if (name == "parabola") return polynomial<d>(0.5, 0, 1);
    return wave<d>();
}

template <int d>
std::string profile(const Estimated<d>& e) {
    const auto all = schemes<d>();
    std::string csv = d == 1 ? "x" : "x,y";
    for (const auto& scheme : all) {
        if (scheme.value) csv += "," + scheme.name;
        csv += "," + scheme.name + "_slope";
    }
    csv += ",exact,exact_slope\n";
    const auto cell = [](double value) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.17g", value);
        return std::string{text.data()};
    };
    for (std::size_t i = 0; i < e.exact.size(); ++i) {
        csv += cell(e.x[0][i]);
        if (d > 1) csv += "," + cell(e.x[d - 1][i]);
        for (const auto& scheme : all) {
            if (scheme.value) csv += "," + cell((e.*scheme.value)[i]);
            csv += "," + cell((e.*scheme.slope)[0][i]);
        }
        csv += "," + cell(e.exact[i]) + "," + cell(e.exact_slope[0][i]) + "\n";
    }
    return csv;
}

template <int d>
void interpolate_in(report::Run& run, const Options& options) {
    const auto e = estimate<d>(options.set(run), function_named<d>(options.function));
    const auto n = static_cast<long>(e.exact.size());
    plot::Figure figure{"interpolate", 1, 2};
    plot::Panel& left =
        figure.at(0, 0).titled("values at the particles").labels("exact $A$", "interpolated $A$");
    plot::Panel& right =
        figure.at(0, 1).titled("slopes along $x$").labels("exact ∂$A$/∂$x$", "estimated ∂$A$/∂$x$");
    const auto diagonal = [](plot::Panel& panel, const Column& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        panel.curve({*low, *high}, {*low, *high}, {.label = "exact", .colour = plot::Colour{0, 0, 0}});
    };
    diagonal(left, e.exact);
    diagonal(right, e.exact_slope[0]);
    for (const auto& scheme : schemes<d>()) {
        plot::Style dots = scheme_style(scheme);
        dots.width = 0;
        dots.marker_size = 3;
        const auto errors = [&](const std::string& where, Where region) {
            // A constant's slope is zero, so its relative error does not exist.
            if (scheme.value) run.result(scheme.name, n, "l2_f" + where, value_error(e, scheme, region));
            const double slope = slope_error(e, scheme, region);
            if (std::isfinite(slope)) run.result(scheme.name, n, "l2_slope" + where, slope);
        };
        errors("", Where::everywhere);
        if (std::any_of(e.inside.begin(), e.inside.end(), [](bool inside) { return inside; }))
            errors("_inside", Where::inside);
        if (scheme.value) left.points(e.exact, e.*scheme.value, dots);
        if (scheme.name != "sph") right.points(e.exact_slope[0], (e.*scheme.slope)[0], dots);
    }
    run.result("repairs", n, "flagged", static_cast<double>(e.repairs.flagged));
    run.result("repairs", n, "left", static_cast<double>(e.repairs.left));
    right.legend.shown = false;
    run.write("profile.csv", profile(e));
    run.save(figure);
}

}  // namespace

ParticleSet Options::set(const report::Run& run) const {
    return {kernel,
            arrangement_named(arrangement),
            static_cast<std::size_t>(particles),
            h_over_dx,
            jitter,
            run.seed(),
            volumes == "equal" ? Volumes::equal : Volumes::summed,
            run.threads()};
}

void Options::declare(app::CommandLine& line) {
    line.choice("kernel", kernel, {"cubic", "quintic", "wendland-c4"},
                "smoothing kernel of the scene and of the figures that show one")
        .number("h-over-dx", h_over_dx, {0.5, 8}, "spacings", "smoothing length h")
        .number("jitter", jitter, {0, 0.5}, "spacings", "largest random shift of a particle along each axis")
        .integer("particles", particles, 8, 4096, "particles along each side of the box, in the scene")
        .integer("dimension", dimension, 1, 2, "of the scene")
        .choice("arrangement", arrangement, {"even", "jittered", "random"}, "of the particles in the scene")
        .choice("volumes", volumes, {"summed", "equal"},
                "of the particles: m/rho with summed densities, or 1/N")
        .choice("function", function, {"wave", "two-gaussians", "constant", "line", "parabola"},
                "that the scene interpolates");
}

void interpolate(report::Run& run, const Options& options) {
    if (options.dimension == 2 && options.particles > 1024)
        throw app::UsageError{"--particles: " + std::to_string(options.particles) +
                              " is not allowed in 2D; allowed: 8..1024"};
    options.dimension == 1 ? interpolate_in<1>(run, options) : interpolate_in<2>(run, options);
}

}  // namespace sph::consistency
