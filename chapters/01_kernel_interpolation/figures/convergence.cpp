#include <array>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/error_curves.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

/// An error in three panels: its name in results, its panel's title.
struct Shown {
    std::string name, title;
    plot::Values ErrorCurves::*error;
};
const std::array<Shown, 3>& shown() {
    static const std::array<Shown, 3> all{{{"value", "$A$ (2.8)", &ErrorCurves::value},
                                           {"gradient", "∇$A$ (2.14)", &ErrorCurves::gradient},
                                           {"laplacian", "∇^{2}$A$ (2.24)", &ErrorCurves::laplacian}}};
    return all;
}

/// The order over the last half of the resolutions.
double last_order(const plot::Values& n, const plot::Values& error) {
    const std::size_t last = n.size() - 1;
    return report::observed_order(n[last / 2], error[last / 2], n[last], error[last]);
}

class ConvergenceFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        plot::Figure figure{"convergence", 2, 3};
        figure.panel_width = 310;
        figure.panel_height = 260;
        report::Table table{{"particles", "A: error (order)", "∇A", "∇²A"}};
        row<1>(run, figure, table);
        row<2>(run, figure, table);
        run.save(figure);
        run.fill("convergence", table.markdown());
    }

  private:
    template <int d>
    void row(report::Run& run, plot::Figure& figure, report::Table& table) const {
        const std::string dimension = std::to_string(d) + "D";
        for (std::size_t k = 0; k < 3; ++k) {
            plot::Panel& panel = figure.at(d - 1, static_cast<int>(k)).titled(shown()[k].title).log_log();
            panel.labels(d == 1 ? "particles $N$" : "particles along a side, $N$^{1/2}",
                         k == 0 ? "relative $L$_{2} error, " + dimension : "");
            panel.legend = {.shown = k == 2 && d == 1, .outside = k == 2};
        }
        std::size_t index = 0;
        for (const ParticleSeries& series : particle_series()) {
            const ErrorCurves curves = error_curves<d>(series, options_, run);
            const plot::Style style{
                .label = series.label, .colour = plot::cycle(index++), .marker = series.marker};
            std::vector<std::string> cells{dimension + ", " + series.plain};
            for (std::size_t k = 0; k < 3; ++k) {
                const plot::Values& error = curves.*shown()[k].error;
                const double order = last_order(curves.n, error);
                figure.at(d - 1, static_cast<int>(k)).curve(curves.n, error, style);
                run.record(series.name + "-" + std::to_string(d) + "d",
                           static_cast<std::size_t>(curves.n.back()),
                           {{"l2_" + shown()[k].name, error.back()}, {"rate_" + shown()[k].name, order}});
                cells.push_back(report::number(error.back(), 2) + " (" + report::fixed(order, 1) + ")");
            }
            table.row(cells);
        }
    }

    SmoothingOptions options_;
};

}  // namespace

report::Task convergence() {
    return ConvergenceFigure{};
}

}  // namespace sph::interpolation
