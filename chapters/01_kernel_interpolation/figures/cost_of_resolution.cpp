#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "common/plot/looks.hpp"
#include "common/report/race.hpp"

/// Error of the slope against CPU seconds over the number of particles, in 1D.
namespace sph::interpolation {
namespace {

report::Contestant kernel_at(report::Run& run, const std::string& kernel, double h_over_dx,
                             Arrangement arrangement) {
    const auto names = kernel_names();
    const auto index = std::find(names.begin(), names.end(), kernel) - names.begin();
    const std::string h = report::number(h_over_dx, 2),
                      label = kernel_label(kernel) + ", $h$ = " + h + " d$x$";
    return {kernel + " h=" + h, label, kernel_style(static_cast<std::size_t>(index), label, true),
            [=, &run](std::size_t n) {
                const Setting setting{kernel, arrangement, n, h_over_dx, 0.2, run.seed()};
                const double seconds = gradient_ns_per_point<1>(run, setting) / ns * static_cast<double>(n);
                return report::Lap{.error = errors_of<1>(setting).gradient, .seconds = seconds};
            }};
}

/// The k-th of the difference schemes for such points.
report::Contestant differences(report::Run& run, std::size_t k, const std::string& name,
                               const std::string& label, Arrangement arrangement) {
    plot::Style look = plot::competitor(label, k == 0 ? plot::Marker::plus : plot::Marker::cross);
    if (k > 0) look.dash = plot::Dash::dashed;
    return {name, label, look, [=, &run](std::size_t n) {
                const MeasuredDifferences scheme = differences_1d(run, arrangement, n, 0.2).at(k);
                return report::Lap{.error = scheme.error, .seconds = scheme.ns / ns * static_cast<double>(n)};
            }};
}

void race_panel(report::Run& run, plot::Panel& panel, Arrangement arrangement) {
    const bool even = arrangement == Arrangement::even;
    report::RaceCourse course{.name = even ? "even" : "jittered",
                              .sizes = {32, 64, 128, 256, 512, 1024, 2048},
                              .quantity = "l2_gradient",
                              .repeats = 1};  // a lap's time is the best of several already
    if (run.quick()) course.sizes = {32, 128, 512};
    std::vector<report::Contestant> contestants{
        kernel_at(run, "cubic", 1.2, arrangement), kernel_at(run, "quintic", 1.2, arrangement),
        kernel_at(run, "wendland-c4", 2.0, arrangement), kernel_at(run, "super-gaussian", 1.5, arrangement)};
    if (even) {
        contestants.push_back(differences(run, 0, "central-2", "differences, 2nd order", arrangement));
        contestants.push_back(differences(run, 1, "central-4", "differences, 4th order", arrangement));
    } else {
        contestants.push_back(differences(run, 0, "three-point", "three-point differences", arrangement));
    }
    report::draw_error_against_seconds(panel, report::race(run, course, contestants));
}

}  // namespace

void cost_of_resolution(report::Run& run) {
    plot::Figure figure{"cost-of-resolution", 1, 2};
    for (const int column : {0, 1}) {
        plot::Panel& panel = figure.at(0, column).log_log();
        panel.titled(column == 0 ? "even particles, 1D" : "jittered particles, 1D");
        panel.labels("CPU time of all slopes [s]", column == 0 ? "relative $L$_{2} error of d$A$/d$x$" : "");
        race_panel(run, panel, column == 0 ? Arrangement::even : Arrangement::jittered);
    }
    run.save(figure);
}

}  // namespace sph::interpolation
