#include <algorithm>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/01_kernel_interpolation/scenes/measured.hpp"
#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/app/error.hpp"

/// Scenes of the reader's own: `run 01 --scene NAME` with the chapter's options.
namespace sph {
namespace {

/// One row a particle: position, interpolated and exact value, gradient along x and Laplacian.
template <int d>
std::string profile(const Estimates<d>& e) {
    std::string csv = d == 1 ? "x,A,dA_dx,laplacian,exact_A,exact_dA_dx,exact_laplacian\n"
                             : "x,y,A,dA_dx,laplacian,exact_A,exact_dA_dx,exact_laplacian\n";
    for (std::size_t i = 0; i < e.x.size(); ++i) {
        const Vector<d>& x = e.x[i];
        std::vector<double> row(x.begin(), x.end());
        row.insert(row.end(), {e.value[i], e.gradient[i][0], e.laplacian[i], TestFunction<d>::value(x),
                               TestFunction<d>::gradient(x)[0], TestFunction<d>::laplacian(x)});
        csv += report::csv_row(row);
    }
    return csv;
}

template <int d>
plot::Figure figure_of(const Estimates<d>& e, const std::string& kernel) {
    plot::Figure figure{"interpolate"};
    plot::Panel& panel = figure.panel().titled("interpolant and exact value at the particles");
    panel.labels("exact $A$", "interpolated $A$");
    plot::Values exact;
    for (const Vector<d>& x : e.x) exact.push_back(TestFunction<d>::value(x));
    const auto [low, high] = std::minmax_element(exact.begin(), exact.end());
    panel.curve({*low, *high}, {*low, *high}, {.label = "exact", .colour = plot::Colour{0, 0, 0}});
    panel.points(exact, e.value,
                 {.label = kernel_label(kernel), .marker = plot::Marker::circle, .marker_size = 3});
    return figure;
}

template <int d>
void interpolate_in(report::Run& run, const Options& options) {
    const auto estimates = estimates_at_particles<d>(
        {options.kernel, arrangement_named(options.arrangement), static_cast<std::size_t>(options.particles),
         options.h_over_dx, options.jitter, run.seed(), run.threads()});
    const Errors errors = errors_of(estimates);
    const auto n = static_cast<long>(estimates.x.size());
    run.result(options.kernel, n, "l2_value", errors.value);
    run.result(options.kernel, n, "l2_gradient", errors.gradient);
    run.result(options.kernel, n, "l2_laplacian", errors.laplacian);
    run.result(options.kernel, n, "l2_laplacian_twice", errors.twice);
    run.write("profile.csv", profile(estimates));
    run.save(figure_of(estimates, options.kernel));
}

template <int d>
void tabulate_in(report::Run& run, const Options& options) {
    with_kernel<d>(options.kernel, [&](auto kernel) {
        using K = decltype(kernel);
        std::string csv = "q,W,dW_dr,d2W_dr2,F,dW_dh\n";
        for (const double q : linear_space(0, K::support, 201)) {
            csv += report::csv_row(
                {q, K::W(q, 1), K::dW_dr(q, 1), K::d2W_dr2(q, 1), K::F(q, 1), K::dW_dh(q, 1)});
        }
        run.print(csv);
    });
}

}  // namespace

Arrangement arrangement_named(const std::string& name) {
    return name == "even"     ? Arrangement::even
           : name == "random" ? Arrangement::random
                              : Arrangement::jittered;
}

void Options::declare(app::CommandLine& line) {
    line.choice("kernel", kernel, kernel_names(),
                "smoothing kernel of the scenes and of the figures that show one kernel")
        .number("h-over-dx", h_over_dx, {0.5, 8}, "spacings", "smoothing length h")
        .number("jitter", jitter, {0, 1}, "spacings", "largest random shift of a particle along each axis")
        .integer("particles", particles, 8, 1024, "particles along each side of the unit box")
        .integer("dimension", dimension, 1, 3, "of scenes: 1..2 for interpolate, 1..3 for kernel")
        .choice("arrangement", arrangement, {"even", "jittered", "random"}, "of the particles in scenes");
}

void interpolate(report::Run& run, const Options& options) {
    if (options.dimension == 3) throw app::UsageError{"--dimension: 3 is not allowed here; allowed: 1..2"};
    options.dimension == 1 ? interpolate_in<1>(run, options) : interpolate_in<2>(run, options);
}

void tabulate(report::Run& run, const Options& options) {
    if (options.dimension == 1) tabulate_in<1>(run, options);
    if (options.dimension == 2) tabulate_in<2>(run, options);
    if (options.dimension == 3) tabulate_in<3>(run, options);
}

}  // namespace sph
