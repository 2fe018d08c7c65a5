#include "chapters/01_kernel_interpolation/scenes/interpolate.hpp"

#include <algorithm>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/plot/looks.hpp"

namespace sph::interpolation {
namespace {

/// One row a particle: position, interpolated and exact value, gradient along x and Laplacian.
template <int d>
std::string profile(const Estimates<d>& e) {
    constexpr std::string_view axes = "x,y,z,";
    std::string csv{axes.substr(0, 2 * d)};
    csv += "A,dA_dx,laplacian,exact_A,exact_dA_dx,exact_laplacian\n";
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
    panel.curve({*low, *high}, {*low, *high}, plot::exact());
    panel.points(exact, e.value,
                 {.label = kernel_label(kernel), .marker = plot::Marker::circle, .marker_size = 3});
    return figure;
}

}  // namespace

void InterpolateCommand::declare(app::CommandLine& line) {
    options_.declare(line);
    line.integer("dimension", dimension_, 1, 3, "of the box")
        .choice("arrangement", arrangement_, arrangement_names(), "of the particles");
}

template <int d>
void InterpolateCommand::run_in(report::Run& run) const {
    const auto estimates = estimates_at_particles<d>(options_.setting(arrangement_named(arrangement_), run));
    const Errors errors = errors_of(estimates);
    run.record(options_.kernel, estimates.x.size(),
               {{"l2_value", errors.value},
                {"l2_gradient", errors.gradient},
                {"l2_laplacian", errors.laplacian},
                {"l2_laplacian_twice", errors.twice}});
    run.write("profile.csv", profile(estimates));
    run.save(figure_of(estimates, options_.kernel));
}

void InterpolateCommand::run(report::Run& run) const {
    constexpr long most_in_3d = 128;  // two million particles
    if (dimension_ == 3 && options_.particles > most_in_3d)
        throw app::UsageError{"--particles: " + std::to_string(options_.particles) +
                              " along each side; allowed with --dimension 3: 8..128"};
    if (dimension_ == 1) return run_in<1>(run);
    dimension_ == 2 ? run_in<2>(run) : run_in<3>(run);
}

}  // namespace sph::interpolation
