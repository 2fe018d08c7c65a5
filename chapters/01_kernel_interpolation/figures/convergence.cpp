#include <algorithm>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "chapters/01_kernel_interpolation/scenes/measured.hpp"
#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "common/report/norms.hpp"

namespace sph {
namespace {

struct Series {
    std::string name, label, plain;  // in results, in figures, in tables
    Arrangement arrangement;
    bool growing_h;  // h shrinks like sqrt(dx), so that the number of neighbours grows
    plot::Marker marker;
};

const std::vector<Series>& all_series() {
    static const std::vector<Series> series{
        {"even", "even", "even", Arrangement::even, false, plot::Marker::circle},
        {"jittered", "jittered", "jittered", Arrangement::jittered, false, plot::Marker::square},
        {"random", "random", "random", Arrangement::random, false, plot::Marker::triangle_up},
        {"jittered-growing", "jittered, $h$ ∝ d$x$^{1/2}", "jittered, h ∝ √dx", Arrangement::jittered, true,
         plot::Marker::diamond}};
    return series;
}

struct Measured {
    plot::Values n, value, gradient, laplacian, twice;
};

/// Errors over a sequence of resolutions; random points: root mean square over a few sets, for a smooth
/// curve.
template <int d>
Measured measure(const Series& series, const std::vector<std::size_t>& sides, const Options& options,
                 const report::Run& run) {
    Measured m;
    for (const std::size_t n : sides) {
        const double growth = std::sqrt(static_cast<double>(n) / static_cast<double>(sides.front()));
        const double h_over_dx = options.h_over_dx * (series.growing_h ? growth : 1);
        const int sets = series.arrangement == Arrangement::even ? 1 : 4;
        Errors sum;
        for (int set = 0; set < sets; ++set) {
            const Errors e =
                errors_of<d>(Setting{options.kernel, series.arrangement, n, h_over_dx, options.jitter,
                                     run.seed() + static_cast<unsigned long>(set), run.threads()});
            sum.value += square(e.value) / sets;
            sum.gradient += square(e.gradient) / sets;
            sum.laplacian += square(e.laplacian) / sets;
            sum.twice += square(e.twice) / sets;
        }
        m.n.push_back(static_cast<double>(n));
        m.value.push_back(std::sqrt(sum.value));
        m.gradient.push_back(std::sqrt(sum.gradient));
        m.laplacian.push_back(std::sqrt(sum.laplacian));
        m.twice.push_back(std::sqrt(sum.twice));
    }
    return m;
}

std::vector<std::size_t> resolutions(bool quick, int dimension) {
    if (dimension == 1)
        return quick ? std::vector<std::size_t>{32, 64, 128, 256, 512}
                     : std::vector<std::size_t>{32, 64, 128, 256, 512, 1024, 2048, 4096};
    return quick ? std::vector<std::size_t>{16, 24, 32, 48, 64}
                 : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128, 192, 256};
}

plot::Style series_style(const Series& series, std::size_t index) {
    return {.label = series.label, .colour = plot::cycle(index), .marker = series.marker};
}

template <int d>
void convergence_row(report::Run& run, plot::Figure& figure, const Options& options, report::Table& table) {
    std::size_t index = 0;
    for (const Series& series : all_series()) {
        const Measured m = measure<d>(series, resolutions(run.quick(), d), options, run);
        const std::string method = series.name + "-" + std::to_string(d) + "d";
        const plot::Style style = series_style(series, index++);
        std::vector<std::string> cells{std::to_string(d) + "D, " + series.plain};
        const std::array<const plot::Values*, 3> errors{&m.value, &m.gradient, &m.laplacian};
        const std::array names{"value", "gradient", "laplacian"};
        for (std::size_t k = 0; k < 3; ++k) {
            figure.at(d - 1, static_cast<int>(k)).curve(m.n, *errors[k], style);
            const std::size_t last = m.n.size() - 1;
            const double order =
                report::observed_order(m.n[last / 2], (*errors[k])[last / 2], m.n[last], (*errors[k])[last]);
            run.result(method, static_cast<long>(m.n[last]), std::string{"l2_"} + names[k],
                       (*errors[k])[last]);
            run.result(method, static_cast<long>(m.n[last]), std::string{"rate_"} + names[k], order);
            cells.push_back(report::number((*errors[k])[last], 2) + " (" + report::fixed(order, 1) + ")");
        }
        table.row(cells);
    }
    const std::string box = d == 1 ? "particles $N$" : "particles along a side, $N$^{1/2}";
    figure.at(d - 1, 0).titled("$A$ (2.8)").labels(box, "relative $L$_{2} error, " + std::to_string(d) + "D");
    figure.at(d - 1, 1).titled("∇$A$ (2.14)").labels(box, "");
    figure.at(d - 1, 2).titled("∇^{2}$A$ (2.24)").labels(box, "");
    for (int column = 0; column < 3; ++column) {
        figure.at(d - 1, column).log_log();
        figure.at(d - 1, column).legend.shown = false;
    }
    figure.at(d - 1, 2).legend = {.shown = d == 1, .outside = true};
}

}  // namespace

void convergence(report::Run& run, const Options& options) {
    plot::Figure figure{"convergence", 2, 3};
    figure.panel_width = 310;
    figure.panel_height = 260;
    report::Table table{{"particles", "A: error (order)", "∇A", "∇²A"}};
    convergence_row<1>(run, figure, options, table);
    convergence_row<2>(run, figure, options, table);
    run.save(figure);
    run.fill("convergence", table.markdown());
}

void second_derivatives(report::Run& run, const Options& options) {
    plot::Figure figure{"second-derivatives", 1, 2};
    report::Table table{{"particles along a side", "twice differentiated (2.21)", "Brookshaw (2.24)"}};
    const auto draw = [&]<int d>(std::integral_constant<int, d>) {
        plot::Panel& panel = figure.at(0, d - 1).titled(std::to_string(d) + "D").log_log();
        panel.labels(d == 1 ? "particles $N$" : "particles along a side, $N$^{1/2}",
                     "relative $L$_{2} error of ∇^{2}$A$");
        for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
            const Series& series = all_series()[s];
            const Measured m = measure<d>(series, resolutions(run.quick(), d), options, run);
            const bool even = series.arrangement == Arrangement::even;
            panel.curve(m.n, m.twice,
                        {.label = "(2.21), " + series.name,
                         .colour = plot::cycle(1),
                         .dash = even ? plot::Dash::dashed : plot::Dash::solid,
                         .marker = plot::Marker::square,
                         .filled = !even});
            panel.curve(m.n, m.laplacian,
                        {.label = "(2.24), " + series.name,
                         .colour = plot::cycle(0),
                         .dash = even ? plot::Dash::dashed : plot::Dash::solid,
                         .marker = plot::Marker::circle,
                         .filled = !even});
            for (const std::size_t k : {std::size_t{0}, m.n.size() - 1}) {
                const auto n = static_cast<long>(m.n[k]);
                table.row({std::to_string(d) + "D, " + series.name + ", " + std::to_string(n),
                           report::number(m.twice[k], 2), report::number(m.laplacian[k], 2)});
                run.result("twice-" + series.name + "-" + std::to_string(d) + "d", n, "l2_laplacian",
                           m.twice[k]);
                run.result("brookshaw-" + series.name + "-" + std::to_string(d) + "d", n, "l2_laplacian",
                           m.laplacian[k]);
            }
        }
    };
    draw(std::integral_constant<int, 1>{});
    draw(std::integral_constant<int, 2>{});
    run.save(figure);
    run.fill("second-derivatives", table.markdown());
}

}  // namespace sph
