#include "chapters/01_kernel_interpolation/fourier.hpp"

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"
#include "common/plot/looks.hpp"

namespace sph::interpolation {
namespace {

/// The transform in closed form as a line, and by quadrature as circles.
template <class K>
void transform_of(report::Run& run, K kernel, const plot::Style& style, plot::Panel& linear,
                  plot::Panel& decay) {
    const plot::Values coarse = linear_space(0, 8, 17), tail = linear_space(0, 26, 651);  // it has zeros
    plot::Values size, measured;
    for (const double kh : tail) size.push_back(std::max(std::abs(transform(kernel, kh)), 1e-12));
    double largest = 0;
    for (const double kh : coarse) {
        measured.push_back(1 + wave_error(kernel, kh));
        largest = std::max(largest, std::abs(measured.back() - transform(kernel, kh)));
    }
    run.result(std::string{K::name}, 1, "linf_transform", largest, "absolute");
    plot::draw_exact(
        linear, 0, 8, [&](double kh) { return transform(kernel, kh); }, style);
    linear.points(coarse, measured,
                  {.colour = style.colour, .marker = plot::Marker::circle, .filled = false});
    decay.curve(tail, size, style);
}

}  // namespace

void fourier(report::Run& run) {
    plot::Figure figure{"fourier", 1, 2};
    plot::Panel& linear = figure.at(0, 0).titled("lines: closed forms, circles: quadrature");
    plot::Panel& decay = figure.at(0, 1).titled("what even particles feel: the tail");
    linear.labels("$k$ $h$", "Fourier transform of $W$ in 1D").x_range(0, 8);
    decay.labels("$k$ $h$", "|transform|").log_y().y_range(1e-9, 2).x_range(0, 26);
    linear.legend.shown = false;
    decay.legend.outside = true;
    std::size_t index = 0;
    for_each_kernel<1>([&](auto kernel) {
        transform_of(run, kernel, told_style(index++, kernel_label(kernel.name)), linear, decay);
    });
    const double aliased = 2 * pi * 1.2;
    decay.curve({aliased, aliased}, {1e-9, 2},
                {.colour = plot::Colour{0.5, 0.5, 0.5}, .dash = plot::Dash::dashed});
    decay.note(aliased + 0.3, 0.4, "first wave that aliases at $h$ = 1.2 d$x$");
    run.save(figure);
}

}  // namespace sph::interpolation
