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
        table.row(properties(in_1d, in_2d, in_3d));
        const std::string name{in_1d.name};
        run.result(name, 1, "norm_error", norm(in_1d) - 1);
        run.result(name, 2, "norm_error", norm(in_2d) - 1);
        run.result(name, 3, "norm_error", norm(in_3d) - 1);
    });
    run.fill("kernels", table.markdown());
}

}  // namespace sph::interpolation
