#include <algorithm>
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
    static const std::array<Shown, 3> all{{{"value", "$A$ (1.3)", &ErrorCurves::value},
                                           {"gradient", "∇$A$ (1.12)", &ErrorCurves::gradient},
                                           {"laplacian", "∇^{2}$A$ (1.16)", &ErrorCurves::laplacian}}};
    return all;
}

/// The order over the last half of the resolutions.
double last_order(const plot::Values& n, const plot::Values& error) {
    const std::size_t last = n.size() - 1;
    return report::observed_order(n[last / 2], error[last / 2], n[last], error[last]);
}

/// Errors at the highest resolution and observed orders, in the order of shown().
struct Row {
    std::string name;
    std::array<double, 3> error{}, order{};
};
using Rows = std::vector<Row>;

const Row& named(const Rows& rows, std::string_view name) {
    return *std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
}

void fill(report::Run& run, const Rows& rows) {
    report::Table table{{"particles", "A: error [order]", "∇A", "∇²A"}}, all = table;
    for (const Row& row : rows) {
        std::vector<std::string> cells{row.name};
        for (std::size_t k = 0; k < 3; ++k)
            cells.push_back(report::number(row.error[k], 2) + " [" + report::fixed(row.order[k], 1) + "]");
        all.row(cells);
        if (row.name.starts_with("2D") || row.name == "1D, even" || row.name == "3D, jittered")
            table.row(cells);
    }
    run.fill("convergence", table.markdown());
    run.fill("all-convergence", all.markdown());
}

void claims(report::Run& run, const Rows& rows) {
    constexpr std::size_t value = 0, slope = 1, curvature = 2;
    const auto stops = [](double order) { return std::abs(order) < 0.15; };
    run.claim("even-value-converges",
              [&] { return std::abs(named(rows, "1D, even").order[value] - 2) < 0.1; });
    run.claim("even-slope-stops", [&] { return stops(named(rows, "1D, even").order[slope]); });
    run.claim("disorder-stops", [&] {
        for (const char* name : {"1D, jittered", "1D, random", "2D, jittered", "2D, random"}) {
            const Row& row = named(rows, name);
            if (!stops(row.order[value]) || !stops(row.order[slope])) return false;
        }
        return true;
    });
    run.claim("curvature-diverges", [&] {
        return named(rows, "1D, jittered").order[curvature] < -0.9 &&
               named(rows, "2D, jittered").order[curvature] < -0.9;
    });
    run.claim("neighbours-help", [&] {
        const Row& row = named(rows, "2D, jittered, h ∝ √dx");
        return row.order[value] > 0.8 && row.order[slope] > 0.8 && row.order[curvature] > 0.3;
    });
    run.claim("space-is-like-the-plane", [&] {
        const Row &plane = named(rows, "2D, jittered"), &space = named(rows, "3D, jittered");
        const auto near = [&](std::size_t k) {
            return space.error[k] < 2 * plane.error[k] && space.error[k] > 0.5 * plane.error[k];
        };
        return near(value) && near(slope);
    });
}

class ConvergenceFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        plot::Figure figure{"convergence", 3, 3};
        figure.panel_width = 290;
        figure.panel_height = 230;
        Rows rows;
        row<1>(run, figure, rows);
        row<2>(run, figure, rows);
        row<3>(run, figure, rows);
        run.save(figure);
        fill(run, rows);
        claims(run, rows);
    }

  private:
    template <int d>
    void row(report::Run& run, plot::Figure& figure, Rows& rows) const {
        const std::string dimension = std::to_string(d) + "D";
        for (std::size_t k = 0; k < 3; ++k) {
            plot::Panel& panel = figure.at(d - 1, static_cast<int>(k)).titled(shown()[k].title).log_log();
            panel.labels(std::array{"particles $N$", "particles along a side, $N$^{1/2}",
                                    "particles along a side, $N$^{1/3}"}[d - 1],
                         k == 0 ? "relative $L$_{2} error, " + dimension : "");
            panel.legend = {.shown = k == 2 && d == 1, .outside = k == 2};
        }
        std::size_t index = 0;
        for (const ParticleSeries& series : particle_series()) {
            const ErrorCurves curves = error_curves<d>(series, options_, run);
            const plot::Style style{
                .label = series.label, .colour = plot::cycle(index++), .marker = series.marker};
            Row one{.name = dimension + ", " + series.plain};
            for (std::size_t k = 0; k < 3; ++k) {
                const plot::Values& error = curves.*shown()[k].error;
                const double order = last_order(curves.n, error);
                figure.at(d - 1, static_cast<int>(k)).curve(curves.n, error, style);
                run.record(series.name + "-" + std::to_string(d) + "d",
                           static_cast<std::size_t>(curves.n.back()),
                           {{"l2_" + shown()[k].name, error.back()}, {"rate_" + shown()[k].name, order}});
                one.error[k] = error.back();
                one.order[k] = order;
            }
            rows.push_back(one);
        }
    }

    SmoothingOptions options_;
};

}  // namespace

report::Task convergence() {
    return ConvergenceFigure{};
}

}  // namespace sph::interpolation
