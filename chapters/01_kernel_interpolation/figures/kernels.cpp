#include "chapters/01_kernel_interpolation/kernels.hpp"

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"

namespace sph::interpolation {
namespace {

/// The particles in the support at h = 1.2 dx: what one sum costs in pairs.
template <class K>
double neighbours(K) {
    const double reach = K::support * 1.2;
    return sphere_surface<K::dimension> / K::dimension * to_dimension(K::dimension, reach);
}

/// One kernel's W and dW/dr at h = 1.
template <class K>
void draw_shape(plot::Figure& figure, const plot::Style& style) {
    const plot::Values q = linear_space(0, std::min(K::support, 3.2), 161);
    plot::Values w, slope;
    for (const double r : q) {
        w.push_back(K::W(r, 1));
        slope.push_back(K::dW_dr(r, 1));
    }
    figure.at(0, 0).curve(q, w, style);
    figure.at(0, 1).curve(q, slope, style);
}

void draw_shapes(plot::Figure& figure) {
    std::size_t index = 0;
    for_each_kernel<1>([&](auto kernel) {
        draw_shape<decltype(kernel)>(figure, told_style(index++, kernel_label(kernel.name)));
    });
    const plot::Style bad{.label = "$M$_{2}, the hat", .colour = plot::black, .dash = plot::Dash::dotted};
    figure.at(0, 0).curve({0, 1, 3.2}, {1, 0, 0}, bad);
    figure.at(0, 1).curve({0, 1, 1, 3.2}, {-1, -1, 0, 0}, bad);
    figure.at(0, 0).titled("$W$ in 1D").labels("$r$/$h$", "").x_range(0, 3.2).legend.shown = false;
    figure.at(0, 1).titled("d$W$/d$r$").labels("$r$/$h$", "").x_range(0, 3.2).legend.outside = true;
}

/// Support, normalisations, second moments and neighbours of one kernel in all dimensions.
template <class In1D, class In2D, class In3D>
std::vector<std::string> properties(In1D in_1d, In2D in_2d, In3D in_3d) {
    const auto moment = [](double m) { return std::abs(m) < 1e-9 ? "0" : report::number(m, 5); };
    return {kernel_label(in_1d.name),
            report::number(in_1d.support, 2) + " h",
            report::number(in_1d.sigma, 6),
            report::number(in_2d.sigma, 6),
            report::number(in_3d.sigma, 6),
            moment(second_moment(in_1d)),
            moment(second_moment(in_2d)),
            moment(second_moment(in_3d)),
            report::fixed(neighbours(in_1d), 0),
            report::fixed(neighbours(in_2d), 0),
            report::fixed(neighbours(in_3d), 0)};
}

}  // namespace

void kernels(report::Run& run) {
    plot::Figure figure{"kernels", 1, 2};
    figure.panel_width = 330;
    figure.panel_height = 260;
    draw_shapes(figure);
    run.save(figure);
    report::Table table{{"kernel", "support", "σ in 1D", "σ in 2D", "σ in 3D", "⟨x²⟩/h² in 1D", "2D", "3D",
                         "n in 1D", "2D", "3D"}};
    report::Table told{{"kernel", "support", "⟨x²⟩/h² in 1D", "n in 1D", "2D", "3D"}};
    for_each_kernel_in_all_dimensions([&](auto in_1d, auto in_2d, auto in_3d) {
        const std::vector<std::string> row = properties(in_1d, in_2d, in_3d);
        table.row(row);
        if (is_told(in_1d.name)) told.row({row[0], row[1], row[5], row[8], row[9], row[10]});
        const std::string name{in_1d.name};
        run.result(name, 1, "norm_error", norm(in_1d) - 1);
        run.result(name, 2, "norm_error", norm(in_2d) - 1);
        run.result(name, 3, "norm_error", norm(in_3d) - 1);
    });
    run.fill("kernels", told.markdown());
    run.fill("all-kernels", table.markdown());
}

}  // namespace sph::interpolation
