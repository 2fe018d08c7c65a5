#include "chapters/02_consistency/scenes/interpolate.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/02_consistency/figures/figures.hpp"
#include "common/app/error.hpp"
#include "common/plot/looks.hpp"

namespace sph::consistency {
namespace {

template <int d>
Function<d> function_named(const std::string& name) {
    if (name == "two-gaussians") return sum_of_gaussians<d>();
    if (name == "constant") return polynomial<d>(1, 0, 0);
    if (name == "line") return polynomial<d>(0.5, 1, 0);
    if (name == "parabola") return polynomial<d>(0.5, 0, 1);
    return wave<d>();
}

/// One row a particle: position, value and slope along x by every scheme, and the exact ones.
template <int d>
std::string profile(const Estimated<d>& e) {
    report::NamedColumns columns{{"x", e.x[0]}};
    if (d > 1) columns.emplace_back("y", e.x[d - 1]);
    for (const auto& scheme : schemes<d>()) {
        if (scheme.value) columns.emplace_back(scheme.name, e.*scheme.value);
        columns.emplace_back(scheme.name + "_slope", (e.*scheme.slope)[0]);
    }
    columns.emplace_back("exact", e.exact);
    columns.emplace_back("exact_slope", e.exact_slope[0]);
    return report::csv(columns);
}

/// Rows of results.csv of one scheme, over all particles or over those inside.
template <int d>
void record_errors(report::Run& run, const Estimated<d>& e, const Scheme<d>& scheme, Where where) {
    const std::string suffix = where == Where::inside ? "_inside" : "";
    if (scheme.value)
        run.record(scheme.name, e.exact.size(), {{"l2_f" + suffix, value_error(e, scheme, where)}});
    // A constant's slope is zero, so its relative error does not exist.
    const double slope = slope_error(e, scheme, where);
    if (std::isfinite(slope)) run.record(scheme.name, e.exact.size(), {{"l2_slope" + suffix, slope}});
}

template <int d>
plot::Figure figure_of(const Estimated<d>& e) {
    plot::Figure figure{"interpolate", 1, 2};
    plot::Panel& left = figure.at(0, 0).titled("values at the particles");
    plot::Panel& right = figure.at(0, 1).titled("slopes along $x$");
    left.labels("exact $A$", "interpolated $A$");
    right.labels("exact ∂$A$/∂$x$", "estimated ∂$A$/∂$x$");
    right.legend.shown = false;
    const auto diagonal = [](plot::Panel& panel, const Column& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        panel.curve({*low, *high}, {*low, *high}, plot::exact());
    };
    diagonal(left, e.exact);
    diagonal(right, e.exact_slope[0]);
    for (const auto& scheme : schemes<d>()) {
        const plot::Style dots = plot::dots(scheme_style(scheme), 3);
        if (scheme.value) left.points(e.exact, e.*scheme.value, dots);
        if (scheme.name != "sph") right.points(e.exact_slope[0], (e.*scheme.slope)[0], dots);
    }
    return figure;
}

}  // namespace

void SchemesCommand::declare(app::CommandLine& line) {
    options_.declare(line);
    line.integer("particles", particles_, 8, 4096, "particles along each side of the box")
        .integer("dimension", dimension_, 1, 2, "of the box")
        .choice("arrangement", arrangement_, arrangement_names(), "of the particles")
        .choice("function", function_, {"wave", "two-gaussians", "constant", "line", "parabola"},
                "that is interpolated");
}

template <int d>
void SchemesCommand::run_in(report::Run& run) const {
    const ParticleSet set =
        options_.set(arrangement_named(arrangement_), static_cast<std::size_t>(particles_), run);
    const auto e = estimate<d>(set, function_named<d>(function_));
    const bool has_inside = std::find(e.inside.begin(), e.inside.end(), true) != e.inside.end();
    for (const auto& scheme : schemes<d>()) {
        record_errors(run, e, scheme, Where::everywhere);
        if (has_inside) record_errors(run, e, scheme, Where::inside);
    }
    run.record(
        "repairs", e.exact.size(),
        {{"flagged", static_cast<double>(e.repairs.flagged)}, {"left", static_cast<double>(e.repairs.left)}});
    run.write("profile.csv", profile(e));
    run.save(figure_of(e));
}

void SchemesCommand::run(report::Run& run) const {
    if (dimension_ == 2 && particles_ > 1024)
        throw app::UsageError{"--particles: " + std::to_string(particles_) +
                              " is not allowed in 2D; allowed: 8..1024"};
    dimension_ == 1 ? run_in<1>(run) : run_in<2>(run);
}

}  // namespace sph::consistency
