#include "chapters/02_consistency/figures/figures.hpp"

namespace sph::consistency {
namespace {

struct Shape {
    std::string name, label;
    Function<1> function;
};

}  // namespace

void polynomials(report::Run& run, const Options& options) {
    const std::vector<Shape> shapes{{"constant", "a constant", polynomial<1>(1, 0, 0)},
                                    {"line", "a line", polynomial<1>(0.5, 1, 0)},
                                    {"parabola", "a parabola", polynomial<1>(0.5, 0, 1)}};
    plot::Figure figure{"polynomials", 2, 3};
    figure.panel_width = 330;
    figure.panel_height = 250;
    ParticleSet set = options.set(run);
    set.per_side = 21;
    set.arrangement = Arrangement::jittered;
    std::vector<report::Table> tables;
    report::Table table{{"scheme", "constant: A", "slope", "line: A", "slope", "parabola: A", "slope"}};
    std::vector<std::vector<std::string>> rows;
    int column = 0;
    for (const Shape& shape : shapes) {
        const auto e = estimate<1>(set, shape.function);
        plot::Values fine = linear_space(0, 1, 101), exact, exact_slope;
        for (const double x : fine) {
            exact.push_back(shape.function.value({x}));
            exact_slope.push_back(shape.function.gradient({x})[0]);
        }
        plot::Panel& top = figure.at(0, column).titled(shape.label).labels("", column == 0 ? "$A$" : "");
        plot::Panel& bottom = figure.at(1, column).labels("$x$", column == 0 ? "d$A$/d$x$" : "");
        top.curve(fine, exact, {.label = "exact", .colour = plot::Colour{0, 0, 0}, .width = 1.2});
        bottom.curve(fine, exact_slope, {.label = "exact", .colour = plot::Colour{0, 0, 0}, .width = 1.2});
        std::size_t row = 0;
        for (const auto& scheme : schemes<1>()) {
            if (rows.size() <= row) rows.push_back({scheme.label});
            plot::Style style = scheme_style(scheme);
            style.width = 0;
            style.marker_size = 4.5;
            style.layer = 2;
            double worst = 0, worst_slope = 0;
            for (std::size_t i = 0; i < e.exact.size(); ++i) {
                if (scheme.value) worst = std::max(worst, std::abs((e.*scheme.value)[i] - e.exact[i]));
                worst_slope = std::max(worst_slope, std::abs((e.*scheme.slope)[0][i] - e.exact_slope[0][i]));
            }
            if (scheme.value) {
                top.curve(e.x[0], e.*scheme.value, style);
                run.result(scheme.name + " " + shape.name, 21, "linf_f", worst, "absolute");
            }
            // SPH's slopes would hide the others.
            if (scheme.name != "sph") bottom.curve(e.x[0], (e.*scheme.slope)[0], style);
            run.result(scheme.name + " " + shape.name, 21, "linf_slope", worst_slope, "absolute");
            const auto shown = [](double error) {
                return error < 1e-11 ? "exact" : report::number(error, 2);
            };
            rows[row].push_back(scheme.value ? shown(worst) : "");
            rows[row++].push_back(shown(worst_slope));
        }
        if (shape.name == "constant") bottom.y_range(-0.1, 0.1);  // what differs from zero there is rounding
        top.legend.shown = column == 2;
        top.legend.outside = true;
        bottom.legend.shown = column == 2;
        bottom.legend.outside = true;
        ++column;
    }
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("polynomials", table.markdown());

    // CSPM's second derivative of the parabola: right on even particles inside, stuck on jittered ones.
    report::Table curvature{{"particles", "largest error of A″ = 2 inside"}};
    for (const std::size_t n : {std::size_t{100}, std::size_t{1000}}) {
        for (const Arrangement arrangement : {Arrangement::even, Arrangement::jittered}) {
            set.per_side = n;
            set.arrangement = arrangement;
            const Curvature c = cspm_curvature(set, shapes[2].function);
            double worst = 0;
            for (std::size_t i = 0; i < c.x.size(); ++i) {
                if (c.x[i] > 0.1 && c.x[i] < 0.9) worst = std::max(worst, std::abs(c.value[i] - 2));
            }
            const std::string name = arrangement == Arrangement::even ? "even" : "jittered";
            run.result("cspm parabola " + name, static_cast<long>(n), "linf_curvature", worst, "absolute");
            curvature.row(
                {std::to_string(n) + ", " + name, worst < 1e-9 ? "exact" : report::number(worst, 2)});
        }
    }
    run.fill("curvature", curvature.markdown());
}

}  // namespace sph::consistency
