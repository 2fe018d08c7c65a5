#include <algorithm>
#include <cmath>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/options.hpp"
#include "common/plot/looks.hpp"

namespace sph::consistency {
namespace {

struct Shape {
    std::string name, label;
    Function<1> function;
};

void draw_exact(plot::Panel& top, plot::Panel& bottom, const Function<1>& function) {
    const plot::Values fine = linear_space(0, 1, 101);
    plot::Values exact, exact_slope;
    for (const double x : fine) {
        exact.push_back(function.value({x}));
        exact_slope.push_back(function.gradient({x})[0]);
    }
    plot::Style style = plot::exact();
    style.width = 1.2;
    top.curve(fine, exact, style);
    bottom.curve(fine, exact_slope, style);
}

double largest_error(const Column& value, const Column& exact) {
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) worst = std::max(worst, std::abs(value[i] - exact[i]));
    return worst;
}

std::string shown(double error, double rounding) {
    return error < rounding ? "exact" : report::number(error, 2);
}

/// One column of panels, and the cells of each scheme's row.
void draw_shape(report::Run& run, plot::Figure& figure, int column, const Shape& shape, const Estimated<1>& e,
                std::vector<std::vector<std::string>>& rows) {
    plot::Panel& top = figure.at(0, column).titled(shape.label).labels("", column == 0 ? "$A$" : "");
    plot::Panel& bottom = figure.at(1, column).labels("$x$", column == 0 ? "d$A$/d$x$" : "");
    draw_exact(top, bottom, shape.function);
    const auto all = schemes<1>();
    for (std::size_t k = 0; k < all.size(); ++k) {
        plot::Style style = plot::dots(scheme_style(all[k]), 4.5);
        style.layer = 2;
        const std::string name = all[k].name + " " + shape.name;
        const Column& slope = (e.*all[k].slope)[0];
        rows[k].emplace_back("");
        if (all[k].value) {
            const double worst = largest_error(e.*all[k].value, e.exact);
            top.curve(e.x[0], e.*all[k].value, style);
            run.result(name, 21, "linf_f", worst, "absolute");
            rows[k].back() = shown(worst, 1e-11);
        }
        // SPH's slopes would hide the others.
        if (all[k].name != "sph") bottom.curve(e.x[0], slope, style);
        const double worst_slope = largest_error(slope, e.exact_slope[0]);
        run.result(name, 21, "linf_slope", worst_slope, "absolute");
        rows[k].push_back(shown(worst_slope, 1e-11));
    }
    if (shape.name == "constant") bottom.y_range(-0.1, 0.1);  // what differs from zero there is rounding
    top.legend = bottom.legend = {.shown = column == 2, .outside = true};
}

class PolynomialsFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        const std::vector<Shape> shapes{{"constant", "a constant", polynomial<1>(1, 0, 0)},
                                        {"line", "a line", polynomial<1>(0.5, 1, 0)},
                                        {"parabola", "a parabola", polynomial<1>(0.5, 0, 1)}};
        plot::Figure figure{"polynomials", 2, 3};
        figure.panel_width = 330;
        figure.panel_height = 250;
        std::vector<std::vector<std::string>> rows;
        for (const auto& scheme : schemes<1>()) rows.push_back({scheme.label});
        for (int column = 0; column < 3; ++column) {
            const Shape& shape = shapes[static_cast<std::size_t>(column)];
            const auto e = estimate<1>(options_.set(Arrangement::jittered, 21, run), shape.function);
            draw_shape(run, figure, column, shape, e, rows);
        }
        report::Table table{{"scheme", "constant: A", "slope", "line: A", "slope", "parabola: A", "slope"}};
        for (const auto& row : rows) table.row(row);
        run.save(figure);
        run.fill("polynomials", table.markdown());
        fill_curvature(run, shapes[2].function);
        const auto exact = [&](const char* scheme, std::size_t column) {
            return std::any_of(rows.begin(), rows.end(), [&](const std::vector<std::string>& row) {
                return row[0] == scheme && row[column] == "exact";
            });
        };
        run.claim(
            "line-exact",
            [&] {
                return exact("CSPM", 4) && exact("linearly exact", 4) && exact("fitted line", 4) &&
                       !exact("SPH", 4) && !exact("differences", 4);
            },
            report::Needs::any_run);
        run.claim(
            "value-exact", [&] { return exact("fitted line", 3) && exact("CSPM", 1) && !exact("CSPM", 3); },
            report::Needs::any_run);
    }

  private:
    /// CSPM's second derivative of the parabola: right on even particles inside, stuck on jittered ones.
    void fill_curvature(report::Run& run, const Function<1>& parabola) const {
        report::Table table{{"particles", "largest error of A″ = 2 inside"}};
        plot::Values jittered;
        for (const std::size_t n : {std::size_t{100}, std::size_t{1000}}) {
            for (const Arrangement arrangement : {Arrangement::even, Arrangement::jittered}) {
                const Curvature c = cspm_curvature(options_.set(arrangement, n, run), parabola);
                double worst = 0;
                for (std::size_t i = 0; i < c.x.size(); ++i) {
                    if (c.x[i] > 0.1 && c.x[i] < 0.9) worst = std::max(worst, std::abs(c.value[i] - 2));
                }
                const std::string name = arrangement == Arrangement::even ? "even" : "jittered";
                run.record("cspm parabola " + name, n, {{"linf_curvature", worst, "absolute"}});
                table.row({std::to_string(n) + ", " + name, shown(worst, 1e-9)});
                if (arrangement == Arrangement::jittered) jittered.push_back(worst);
            }
        }
        run.fill("curvature", table.markdown());
        run.claim(
            "curvature-stuck", [&] { return jittered.back() > 0.5 * jittered.front(); },
            report::Needs::any_run);
    }

    ParticleSetOptions options_;
};

}  // namespace

report::Task polynomials() {
    return PolynomialsFigure{};
}

}  // namespace sph::consistency
