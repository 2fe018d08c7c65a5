#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/fourier.hpp"

namespace sph::interpolation {
namespace {

/// Sums over even particles of spacing 1 around one at the origin, by themselves: what the formulas predict.
template <class K>
struct EvenSums {
    double constant = -1, slope = -1;  // relative errors
    EvenSums(K, double h) {
        const int reach = static_cast<int>(std::ceil(K::support * h));
        for (int j = -reach; j <= reach; ++j) {
            const double r = std::abs(j);
            constant += K::W(r, h);
            slope -= r * r * K::F(r, h);
        }
    }
};

/// Log axes end here: what lies below is rounding.
double visible(double error) {
    return std::max(std::abs(error), 1e-17);
}

struct Worst {
    double constant = 0, slope = 0;
};

template <class K>
Worst compare(K kernel, std::size_t index, plot::Panel& constant, plot::Panel& slope, std::size_t points) {
    Worst worst;
    const plot::Values fine = linear_space(0.8, 2.5, points);
    plot::Values constant_formula, slope_formula, marked, constant_sum, slope_sum;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const double h = fine[i];
        const double c = constant_error(kernel, h), s = slope_error(kernel, h);
        const EvenSums<K> sums{kernel, h};
        worst.constant = std::max(worst.constant, std::abs(sums.constant - c));
        worst.slope = std::max(worst.slope, std::abs(sums.slope - s));
        constant_formula.push_back(visible(c));
        slope_formula.push_back(visible(s));
        if (i % ((points - 1) / 17) == 0) {
            marked.push_back(h);
            constant_sum.push_back(visible(sums.constant));
            slope_sum.push_back(visible(sums.slope));
        }
    }
    const plot::Style line = told_style(index, kernel_label(K::name));
    const plot::Style dots{.colour = line.colour, .marker = plot::Marker::circle, .filled = false};
    constant.curve(fine, constant_formula, line);
    constant.points(marked, constant_sum, dots);
    slope.curve(fine, slope_formula, line);
    slope.points(marked, slope_sum, dots);
    return worst;
}

/// The smallest h/dx from which on, up to 12.5 (where no spline has a zero), the slope of a line is right to
/// `tolerance`; "> 12" if there is none below 12.
template <class K>
std::string enough_for(K kernel, double tolerance) {
    for (int hundredths = 1250; hundredths >= 80; --hundredths) {
        const double h = hundredths / 100.0;
        if (std::abs(EvenSums<K>{kernel, h}.slope) > tolerance) {
            return hundredths >= 1200 ? "> 12" : report::fixed(h + 0.01, 2);
        }
    }
    return "≤ 0.8";
}

/// The quartic spline's happens to vanish at h = 1.2 dx: not worth the digits of rounding.
std::string curvature_text(double curvature) {
    return std::abs(curvature) < 1e-12 ? "0" : report::number(curvature, 2);
}

/// What the text says of these sums.
void say_of_sums(report::Run& run, const Worst& of_all) {
    const auto needs = report::Needs::any_run;
    run.claim(
        "poisson", [&] { return of_all.constant < 1e-12 && of_all.slope < 1e-12; }, needs);
    const auto hat = [](double h) { return EvenSums<HatSpline<1>>{{}, h}.slope; };
    run.fill("hat-below", report::fixed(1 + hat(1.99), 2));
    run.fill("hat-above", report::fixed(1 + hat(2.01), 2));
    run.claim(
        "hat-leaps", [&] { return hat(1.99) < -0.45 && hat(2.01) > 0.45; }, needs);
    const auto cubic = [](double h) { return std::abs(EvenSums<CubicSpline<1>>{{}, h}.slope); };
    run.claim(
        "exact-at-dx", [&] { return cubic(1) < 1e-13 && cubic(2) < 1e-13; }, needs);
    run.claim(
        "worst-at-usual",
        [&] {
            double most = 0;
            for (const double h : linear_space(1, 2, 101)) most = std::max(most, cubic(h));
            return cubic(1.2) > 0.85 * most;
        },
        needs);
    run.claim(
        "gaussian-falls",
        [] {
            const double ratio =
                EvenSums<Gaussian<1>>{{}, 1.5}.constant / EvenSums<Gaussian<1>>{{}, 1.6}.constant;
            return ratio > 15 && ratio < 30;
        },
        needs);
}

}  // namespace

void summation_error(report::Run& run) {
    plot::Figure figure{"summation-error", 1, 2};
    figure.panel_width = 430;
    figure.panel_height = 360;
    plot::Panel& constant = figure.at(0, 0).titled("a constant");
    plot::Panel& slope = figure.at(0, 1).titled("the slope of a straight line (1.12)");
    for (plot::Panel* panel : {&constant, &slope}) {
        panel->labels("$h$/d$x$", "|relative error|").log_y().x_range(0.8, 2.5).y_range(1e-16, 1);
    }
    constant.legend.shown = false;
    slope.legend.outside = true;
    slope.legend.title = "circles: sums";
    report::Table table{
        {"kernel", "constant", "slope", "h/dx for 1 %", "for 0.1 %", "for 10⁻⁶", "1″ by (1.15)"}};
    report::Table told{{"kernel", "constant", "slope", "h/dx for 1 %", "for 0.1 %"}};
    std::size_t index = 0;
    Worst of_all;
    for_each_kernel<1>([&](auto kernel) {
        using K = decltype(kernel);
        const std::string name{K::name};
        const Worst worst = compare(kernel, index++, constant, slope, run.quick() ? 171 : 341);
        run.result(name, 1, "linf_constant_sum_against_poisson", worst.constant, "absolute");
        run.result(name, 1, "linf_slope_sum_against_poisson", worst.slope, "absolute");
        run.result(name, 1, "constant_error_at_1.2", constant_error(kernel, 1.2));
        run.result(name, 1, "slope_error_at_1.2", slope_error(kernel, 1.2));
        const std::vector<std::string> row{kernel_label(name),
                                           report::number(constant_error(kernel, 1.2), 2),
                                           report::number(slope_error(kernel, 1.2), 2),
                                           enough_for(kernel, 1e-2),
                                           enough_for(kernel, 1e-3),
                                           enough_for(kernel, 1e-6),
                                           curvature_text(constant_curvature(kernel, 1.2))};
        table.row(row);
        if (is_told(name)) told.row({row.begin(), row.begin() + 5});
        of_all.constant = std::max(of_all.constant, worst.constant);
        of_all.slope = std::max(of_all.slope, worst.slope);
    });
    run.save(figure);
    run.fill("summation", told.markdown());
    run.fill("all-summation", table.markdown());
    say_of_sums(run, of_all);
    run.fill("cut-gaussian", report::number(std::abs(EvenSums<Gaussian<1, 3>>{{}, 2.0}.slope), 2));
}

}  // namespace sph::interpolation
