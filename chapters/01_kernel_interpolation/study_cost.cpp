#include <algorithm>
#include <numeric>

#include "chapters/01_kernel_interpolation/finite_differences.hpp"
#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/measured.hpp"
#include "chapters/01_kernel_interpolation/studies.hpp"
#include "chapters/01_kernel_interpolation/test_function.hpp"
#include "common/report/norms.hpp"

/// What accuracy costs: error against measured CPU time, for every kernel, beside central differences. Times
/// are of one thread, the best of several samples, for evaluation alone: the particles are sorted beforehand.
namespace sph {
namespace {

constexpr double ns = 1e9;

template <class K>
Interpolation<K> interpolation_of(const Setting& s) {
    constexpr int d = K::dimension;
    return {make_points<d>(s.arrangement, s.per_side, s.jitter, s.seed),
            s.h_over_dx / static_cast<double>(s.per_side), TestFunction<d>{}};
}

/// CPU nanoseconds a particle for the listed estimates.
template <class... Estimates, class K>
double ns_per_point(report::Run& run, const Interpolation<K>& A) {
    double sum = 0;
    const report::Timing timing = run.time([&] {
        for (std::size_t i = 0; i < A.size(); ++i) sum += std::get<0>(A.template at<Estimates...>(i))[0];
        report::keep(sum);
    });
    return ns * timing.best / static_cast<double>(A.size());
}

/// Values and exact slopes of the test function on points in 1D, from left to right, and its slope by
/// differences.
struct Line {
    plot::Values x, A, exact, slope;
    Line(Arrangement arrangement, std::size_t n, double jitter, std::uint64_t seed)
        : x{make_points<1>(arrangement, n, jitter, seed)[0]}, slope(n) {
        std::sort(x.begin(), x.end());
        for (const double position : x) {
            A.push_back(TestFunction<1>::value({position}));
            exact.push_back(TestFunction<1>::gradient({position})[0]);
        }
    }
};

/// A competitor: its name, label, error, and CPU nanoseconds a point.
struct Competitor {
    std::string name, label;
    double error = 0, ns = 0;
};

std::vector<Competitor> differences_1d(report::Run& run, Arrangement arrangement, std::size_t n,
                                       double jitter) {
    Line line{arrangement, n, jitter, run.seed()};
    std::vector<Competitor> result;
    const auto measure = [&](std::string name, std::string label, const auto& scheme) {
        const report::Timing timing = run.time([&] {
            scheme();
            report::keep(line.slope.data());
        });
        result.push_back({std::move(name), std::move(label), report::l2_error(line.slope, line.exact),
                          ns * timing.best / static_cast<double>(n)});
    };
    if (arrangement == Arrangement::even) {
        measure("central-2", "differences, 2nd order", [&] { central_2(line.A, line.slope); });
        measure("central-4", "differences, 4th order", [&] { central_4(line.A, line.slope); });
    } else {
        measure("three-point", "three-point differences", [&] { three_point(line.x, line.A, line.slope); });
    }
    return result;
}

std::vector<Competitor> differences_2d(report::Run& run, std::size_t n) {
    plot::Values A(n * n), slope_x(n * n), slope_y(n * n);
    const Columns<2> lattice = make_points<2>(Arrangement::even, n, 0, 0);
    for (std::size_t i = 0; i < n * n; ++i) A[i] = TestFunction<2>::value({lattice[0][i], lattice[1][i]});
    const report::Timing timing = run.time([&] {
        central_gradient_2d(A, n, slope_x, slope_y);
        report::keep(slope_x.data());
    });
    plot::Values slope = slope_x, exact;
    slope.insert(slope.end(), slope_y.begin(), slope_y.end());
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        for (std::size_t i = 0; i < n * n; ++i) {
            exact.push_back(TestFunction<2>::gradient({lattice[0][i], lattice[1][i]})[axis]);
        }
    }
    const double error = report::l2_error(slope, exact);
    return {{"central-2", "differences, 2nd order", error, ns * timing.best / static_cast<double>(n * n)}};
}

/// The best h/dx of one kernel: what it reaches, and what that costs.
struct Best {
    double h_over_dx = 0, error = 1e300, ns = 0;
};

template <class K>
Best scan_h(report::Run& run, plot::Panel& panel, const plot::Style& style, Arrangement arrangement,
            std::size_t n, const std::string& method) {
    const plot::Values all{0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0};
    const plot::Values some{1.0, 1.2, 2.0};
    Best best;
    plot::Values time, error;
    for (const double h : run.quick() ? some : all) {
        const Setting setting{std::string{K::name}, arrangement, n, h, 0.2, run.seed()};
        const Interpolation<K> A = interpolation_of<K>(setting);
        time.push_back(ns_per_point<DifferenceGradient>(run, A));
        error.push_back(errors_of<K::dimension>(setting).gradient);
        const auto size = static_cast<long>(A.size());
        run.result(method + " h=" + report::number(h, 2), size, "l2_gradient", error.back());
        run.result(method + " h=" + report::number(h, 2), size, "cpu_ns_per_point", time.back(), "ns");
        if (error.back() < best.error) best = {h, error.back(), time.back()};
    }
    panel.curve(time, error, style);
    return best;
}

struct CostPanel {
    int row, column, dimension;
    Arrangement arrangement;
    std::string name;
};

template <int d>
void cost_panel(report::Run& run, plot::Panel& panel, const CostPanel& which,
                std::vector<std::vector<std::string>>& rows) {
    const std::size_t n = d == 1 ? 128 : 48;
    std::size_t index = 0;
    const auto cell = [](double h, double error, double time) {
        return report::number(error, 2) + (h > 0 ? " at h/dx = " + report::number(h, 2) : "") + ", " +
               report::timing(time) + " ns";
    };
    for_each_kernel<d>([&](auto kernel) {
        using K = decltype(kernel);
        const plot::Style style = kernel_style(index, kernel_label(K::name), true);
        const Best best =
            scan_h<K>(run, panel, style, which.arrangement, n, which.name + " " + std::string{K::name});
        rows[index++].push_back(cell(best.h_over_dx, best.error, best.ns));
    });
    const auto competitors = d == 1 ? differences_1d(run, which.arrangement, n, 0.2) : differences_2d(run, n);
    std::string cells;
    for (const Competitor& c : competitors) {
        const bool fourth = c.name == "central-4";
        panel.points({c.ns}, {c.error},
                     {.label = c.label,
                      .colour = plot::Colour{0, 0, 0},
                      .marker = fourth ? plot::Marker::cross : plot::Marker::plus,
                      .marker_size = 8});
        run.result(which.name + " " + c.name, static_cast<long>(n), "l2_gradient", c.error);
        run.result(which.name + " " + c.name, static_cast<long>(n), "cpu_ns_per_point", c.ns, "ns");
        if (!fourth) cells = cell(0, c.error, c.ns);
    }
    const bool lattice_only = d == 2 && which.arrangement == Arrangement::jittered;
    rows.back().push_back(lattice_only ? "needs a lattice" : cells);
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 2, 2};
    figure.panel_width = 400;
    const std::array<CostPanel, 4> panels{{{0, 0, 1, Arrangement::even, "even-1d"},
                                           {0, 1, 1, Arrangement::jittered, "jittered-1d"},
                                           {1, 0, 2, Arrangement::even, "even-2d"},
                                           {1, 1, 2, Arrangement::jittered, "jittered-2d"}}};
    std::vector<std::vector<std::string>> rows;
    for (const std::string& name : kernel_names()) rows.push_back({kernel_label(name)});
    rows.push_back({"differences, 2nd order"});
    for (const CostPanel& which : panels) {
        plot::Panel& panel = figure.at(which.row, which.column).log_log();
        panel.titled(std::string{which.arrangement == Arrangement::even ? "even" : "jittered"} +
                     " particles, " + std::to_string(which.dimension) + "D");
        panel.labels("CPU time a point [ns]", which.column == 0 ? "relative $L$_{2} error of ∇$A$" : "");
        panel.legend.shown = which.row == 0 && which.column == 1;
        panel.legend.outside = true;
        which.dimension == 1 ? cost_panel<1>(run, panel, which, rows)
                             : cost_panel<2>(run, panel, which, rows);
    }
    run.save(figure);
    report::Table table{{"kernel", "even, 1D", "jittered, 1D", "even, 2D", "jittered, 2D"}};
    for (const auto& row : rows) table.row(row);
    run.fill("cost", table.markdown());
}

namespace {

template <class K>
void resolution_curve(report::Run& run, plot::Panel& panel, Arrangement arrangement, double h_over_dx,
                      std::size_t index, const std::vector<std::size_t>& sizes) {
    const std::string particles = arrangement == Arrangement::even ? "even " : "jittered ";
    plot::Values seconds, error;
    for (const std::size_t n : sizes) {
        const Setting setting{std::string{K::name}, arrangement, n, h_over_dx, 0.2, run.seed()};
        const Interpolation<K> A = interpolation_of<K>(setting);
        seconds.push_back(ns_per_point<DifferenceGradient>(run, A) * static_cast<double>(n) / ns);
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
        const auto A =
            interpolation_of<CubicSpline<2>>({"cubic", Arrangement::jittered, 48, h, 0.2, run.seed()});
        const std::array times{ns_per_point<Value>(run, A), ns_per_point<DifferenceGradient>(run, A),
                               ns_per_point<Value, DifferenceGradient>(run, A),
                               ns_per_point<Value, DifferenceGradient, Brookshaw>(run, A),
                               ns_per_point<Value, DifferenceGradient, Brookshaw, TensorHessian>(run, A)};
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
