#include <array>

#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "chapters/01_kernel_interpolation/figures/figures.hpp"

/// Error against CPU seconds over the number of particles, and what each listed estimate adds.
namespace sph {
namespace {

template <class K>
void resolution_curve(report::Run& run, plot::Panel& panel, Arrangement arrangement, double h_over_dx,
                      std::size_t index, const std::vector<std::size_t>& sizes) {
    const std::string particles = arrangement == Arrangement::even ? "even " : "jittered ";
    plot::Values seconds, error;
    for (const std::size_t n : sizes) {
        const Setting setting{std::string{K::name}, arrangement, n, h_over_dx, 0.2, run.seed()};
        seconds.push_back(ns_per_point<K, DifferenceGradient>(run, setting) * static_cast<double>(n) / ns);
        error.push_back(errors_of<K::dimension>(setting).gradient);
        const std::string method = particles + std::string{K::name} + " h=" + report::number(h_over_dx, 2);
        run.result(method, static_cast<long>(n), "l2_gradient", error.back());
        run.result(method, static_cast<long>(n), "cpu_seconds", seconds.back(), "s");
    }
    const std::string label = kernel_label(K::name) + ", $h$ = " + report::number(h_over_dx, 2) + " d$x$";
    panel.curve(seconds, error, kernel_style(index, label, true));
}

void resolution_panel(report::Run& run, plot::Panel& panel, Arrangement arrangement) {
    const std::vector<std::size_t> sizes = run.quick()
                                               ? std::vector<std::size_t>{32, 128, 512}
                                               : std::vector<std::size_t>{32, 64, 128, 256, 512, 1024, 2048};
    resolution_curve<CubicSpline<1>>(run, panel, arrangement, 1.2, 2, sizes);
    resolution_curve<QuinticSpline<1>>(run, panel, arrangement, 1.2, 4, sizes);
    resolution_curve<WendlandC4<1>>(run, panel, arrangement, 2.0, 7, sizes);
    resolution_curve<SuperGaussian<1>>(run, panel, arrangement, 1.5, 1, sizes);
    std::vector<plot::Values> seconds, error;
    std::vector<Competitor> last;
    for (const std::size_t n : sizes) {
        last = differences_1d(run, arrangement, n, 0.2);
        seconds.resize(last.size());
        error.resize(last.size());
        for (std::size_t c = 0; c < last.size(); ++c) {
            seconds[c].push_back(last[c].ns * static_cast<double>(n) / ns);
            error[c].push_back(last[c].error);
            run.result((arrangement == Arrangement::even ? "even " : "jittered ") + last[c].name,
                       static_cast<long>(n), "l2_gradient", last[c].error);
        }
    }
    for (std::size_t c = 0; c < last.size(); ++c) {
        panel.curve(seconds[c], error[c],
                    {.label = last[c].label,
                     .colour = plot::Colour{0, 0, 0},
                     .dash = c == 0 ? plot::Dash::solid : plot::Dash::dashed,
                     .marker = c == 0 ? plot::Marker::plus : plot::Marker::cross});
    }
}

}  // namespace

void cost_of_resolution(report::Run& run) {
    plot::Figure figure{"cost-of-resolution", 1, 2};
    for (const int column : {0, 1}) {
        plot::Panel& panel = figure.at(0, column).log_log();
        panel.titled(column == 0 ? "even particles, 1D" : "jittered particles, 1D");
        panel.labels("CPU time of all slopes [s]", column == 0 ? "relative $L$_{2} error of d$A$/d$x$" : "");
        resolution_panel(run, panel, column == 0 ? Arrangement::even : Arrangement::jittered);
    }
    run.save(figure);
}

void cost_of_estimates(report::Run& run) {
    plot::Figure figure{"cost-of-estimates", 1, 1};
    plot::Panel& panel = figure.panel().titled("2D, cubic spline: only what is listed is computed");
    panel.labels("$h$/d$x$", "CPU time a point [ns]");
    struct Curve {
        std::string name;
        plot::Values time;
    };
    std::vector<Curve> curves{{"value", {}},
                              {"gradient", {}},
                              {"value + gradient", {}},
                              {"value + gradient + Laplacian", {}},
                              {"all and the tensor (2.31)", {}}};
    const plot::Values hs = run.quick() ? plot::Values{1.2, 2.0} : plot::Values{1.0, 1.2, 1.5, 2.0, 2.5};
    for (const double h : hs) {
        const Setting s{"cubic", Arrangement::jittered, 48, h, 0.2, run.seed()};
        using K = CubicSpline<2>;
        const std::array times{ns_per_point<K, Value>(run, s), ns_per_point<K, DifferenceGradient>(run, s),
                               ns_per_point<K, Value, DifferenceGradient>(run, s),
                               ns_per_point<K, Value, DifferenceGradient, Brookshaw>(run, s),
                               ns_per_point<K, Value, DifferenceGradient, Brookshaw, TensorHessian>(run, s)};
        for (std::size_t c = 0; c < curves.size(); ++c) {
            curves[c].time.push_back(times[c]);
            run.result(curves[c].name + " h=" + report::number(h, 2), 2304, "cpu_ns_per_point", times[c],
                       "ns");
        }
    }
    report::Table table{{"listed", "ns a point at h = 1.2 dx", "at h = 2 dx"}};
    for (std::size_t c = 0; c < curves.size(); ++c) {
        panel.curve(hs, curves[c].time, {.label = curves[c].name, .marker = plot::Marker::circle});
        const auto at = [&](double h) {
            const auto k = static_cast<std::size_t>(std::find(hs.begin(), hs.end(), h) - hs.begin());
            return report::timing(curves[c].time[k]);
        };
        table.row({curves[c].name, at(1.2), at(2.0)});
    }
    run.save(figure);
    run.fill("cost-of-estimates", table.markdown());
}

}  // namespace sph
