#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

/// Error of the integral interpolant of the wave cos(k.x) against k h, and its order between small k h.
template <int d>
void orders(report::Run& run, plot::Panel& panel, std::vector<std::vector<std::string>>& rows) {
    panel.titled(std::to_string(d) + "D").labels("$k$ $h$", "relative error of a wave").log_log();
    panel.slope(2, 0.03, 0.2, 4e-3, "order 2");
    panel.slope(4, 0.06, 0.4, 2e-8, "order 4");
    panel.legend.shown = d == 3;
    panel.legend.outside = true;
    std::size_t index = 0;
    for_each_kernel<d>([&](auto kernel) {
        using K = decltype(kernel);
        const plot::Values kh = log_space(0.02, 2, 21);
        plot::Values error;
        for (const double k : kh) error.push_back(std::abs(wave_error(kernel, k)));
        panel.curve(kh, error, kernel_style(index, kernel_label(K::name)));
        const double order = -report::observed_order(kh[2], error[2], kh[6], error[6]);
        run.result(std::string{K::name}, d, "rate_wave", order);
        rows[index++].push_back(report::fixed(order, 2));
    });
}

}  // namespace

void integral_error(report::Run& run) {
    plot::Figure figure{"integral-error", 1, 3};
    figure.panel_width = 330;
    figure.share_y = true;
    std::vector<std::vector<std::string>> rows;
    for (const std::string& name : kernel_names()) rows.push_back({kernel_label(name)});
    orders<1>(run, figure.at(0, 0), rows);
    orders<2>(run, figure.at(0, 1), rows);
    orders<3>(run, figure.at(0, 2), rows);
    run.save(figure);
    report::Table table{{"kernel", "order in 1D", "2D", "3D"}};
    for (const auto& row : rows) table.row(row);
    run.fill("integral-orders", table.markdown());
}

}  // namespace sph::interpolation
