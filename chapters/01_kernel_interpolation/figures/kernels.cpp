#include <map>

#include "chapters/01_kernel_interpolation/fourier.hpp"
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"
#include "chapters/01_kernel_interpolation/figures/figures.hpp"

namespace sph {

std::string kernel_label(std::string_view name) {
    static const std::map<std::string_view, std::string> labels{
        {"gaussian", "Gaussian"},       {"super-gaussian", "super-Gaussian"}, {"cubic", "cubic spline"},
        {"quartic", "quartic spline"},  {"quintic", "quintic spline"},        {"lucy", "Lucy"},
        {"wendland-c2", "Wendland C2"}, {"wendland-c4", "Wendland C4"},       {"wendland-c6", "Wendland C6"}};
    const auto found = labels.find(name);
    return found == labels.end() ? std::string{name} : found->second;
}

plot::Style kernel_style(std::size_t index, const std::string& label, bool markers) {
    using plot::Dash;
    using plot::Marker;
    constexpr std::array dashes{Dash::solid,       Dash::solid,       Dash::solid,
                                Dash::dash_dotted, Dash::dashed,      Dash::dotted,
                                Dash::dashed,      Dash::dash_dotted, Dash::solid};
    constexpr std::array shapes{Marker::circle,  Marker::triangle_up,   Marker::square,
                                Marker::diamond, Marker::triangle_down, Marker::plus,
                                Marker::cross,   Marker::circle,        Marker::square};
    plot::Style style{.label = label, .colour = plot::cycle(index), .dash = dashes.at(index)};
    if (index >= 8) style.colour = plot::Colour{0.45, 0.45, 0.45};  // the cycle would begin anew
    if (markers) {
        style.marker = shapes.at(index);
        style.filled = index < 5;
        style.dash = Dash::solid;
        style.width = 1;
    }
    return style;
}

plot::Values linear_space(double low, double high, std::size_t count) {
    plot::Values values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return values;
}

plot::Values log_space(double low, double high, std::size_t count) {
    plot::Values values = linear_space(std::log(low), std::log(high), count);
    for (double& v : values) v = std::exp(v);
    return values;
}

namespace {

/// The particles in the support at h = 1.2 dx: what one sum costs in pairs.
template <class K>
double neighbours(K) {
    const double reach = K::support * 1.2;
    return sphere_surface<K::dimension> / K::dimension * to_dimension(K::dimension, reach);
}

template <int d>
void shape_panels(plot::Figure& figure, int row) {
    const std::string dimension = std::to_string(d);
    plot::Panel& value = figure.at(row, 0).titled("$W$ in " + dimension + "D");
    plot::Panel& slope = figure.at(row, 1).titled("d$W$/d$r$ in " + dimension + "D");
    plot::Panel& curvature = figure.at(row, 2).titled("d^{2}$W$/d$r$^{2} in " + dimension + "D");
    plot::Panel& by_h = figure.at(row, 3).titled("∂$W$/∂$h$ in " + dimension + "D");
    std::size_t index = 0;
    for_each_kernel<d>([&](auto kernel) {
        using K = decltype(kernel);
        const plot::Values q = linear_space(0, std::min(K::support, 3.2), 161);
        plot::Values w, dw, d2w, dh;
        for (const double r : q) {
            w.push_back(K::W(r, 1));
            dw.push_back(K::dW_dr(r, 1));
            d2w.push_back(K::d2W_dr2(r, 1));
            dh.push_back(K::dW_dh(r, 1));
        }
        const plot::Style style = kernel_style(index++, kernel_label(K::name));
        value.curve(q, w, style);
        slope.curve(q, dw, style);
        curvature.curve(q, d2w, style);
        by_h.curve(q, dh, style);
    });
    for (int column = 0; column < 4; ++column) {
        plot::Panel& panel = figure.at(row, column);
        panel.labels("$r$/$h$", "").x_range(0, 3.2);
        panel.legend.shown = column == 3 && row == 0;
        panel.legend.outside = true;
    }
}

}  // namespace

void kernel_shapes(report::Run& run) {
    plot::Figure figure{"kernels", 2, 4};
    figure.title = "Kernels and their derivatives, $h$ = 1";
    figure.panel_width = 260;
    figure.panel_height = 230;
    shape_panels<1>(figure, 0);
    shape_panels<3>(figure, 1);
    run.save(figure);

    report::Table table{{"kernel", "support", "σ in 1D", "σ in 2D", "σ in 3D", "⟨x²⟩/h² in 1D", "2D", "3D",
                         "n in 1D", "2D", "3D"}};
    for_each_kernel_in_all_dimensions([&](auto in_1d, auto in_2d, auto in_3d) {
        using K = decltype(in_1d);
        const auto moment = [](double m) { return std::abs(m) < 1e-9 ? "0" : report::number(m, 5); };
        table.row({kernel_label(K::name), report::number(K::support, 2) + " h",
                   report::number(in_1d.sigma, 6), report::number(in_2d.sigma, 6),
                   report::number(in_3d.sigma, 6), moment(second_moment(in_1d)), moment(second_moment(in_2d)),
                   moment(second_moment(in_3d)), report::fixed(neighbours(in_1d), 0),
                   report::fixed(neighbours(in_2d), 0), report::fixed(neighbours(in_3d), 0)});
        const std::string name{K::name};
        run.result(name, 1, "norm_error", norm(in_1d) - 1);
        run.result(name, 2, "norm_error", norm(in_2d) - 1);
        run.result(name, 3, "norm_error", norm(in_3d) - 1);
    });
    run.fill("kernels", table.markdown());
}

void fourier_transforms(report::Run& run) {
    plot::Figure figure{"fourier", 1, 2};
    plot::Panel& linear = figure.at(0, 0).titled("lines: closed forms, circles: quadrature");
    plot::Panel& decay = figure.at(0, 1).titled("what even particles feel: the tail");
    linear.labels("$k$ $h$", "Fourier transform of $W$ in 1D").x_range(0, 8);
    decay.labels("$k$ $h$", "|transform|").log_y().y_range(1e-9, 2).x_range(0, 26);
    linear.legend.shown = false;
    std::size_t index = 0;
    for_each_kernel<1>([&](auto kernel) {
        using K = decltype(kernel);
        const plot::Style style = kernel_style(index++, kernel_label(K::name));
        const plot::Values fine = linear_space(0, 26, 651), coarse = linear_space(0, 8, 17);
        plot::Values closed, size, measured;
        for (const double kh : fine) {
            closed.push_back(transform(kernel, kh));
            size.push_back(std::max(std::abs(closed.back()), 1e-12));
        }
        double largest = 0;
        for (const double kh : coarse) {
            measured.push_back(1 + wave_error(kernel, kh));
            largest = std::max(largest, std::abs(measured.back() - transform(kernel, kh)));
        }
        run.result(std::string{K::name}, 1, "linf_transform", largest, "absolute");
        linear.curve(fine, closed, style);
        linear.points(coarse, measured,
                      {.colour = style.colour, .marker = plot::Marker::circle, .filled = false});
        decay.curve(fine, size, style);
    });
    const double aliased = 2 * pi * 1.2;
    decay.curve({aliased, aliased}, {1e-9, 2},
                {.colour = plot::Colour{0.5, 0.5, 0.5}, .dash = plot::Dash::dashed});
    decay.note(aliased + 0.3, 0.4, "first wave that aliases at $h$ = 1.2 d$x$");
    decay.legend.outside = true;
    run.save(figure);
}

}  // namespace sph
