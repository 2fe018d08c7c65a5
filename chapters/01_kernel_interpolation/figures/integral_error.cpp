#include <algorithm>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/integral.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

/// Error of the integral interpolant of the wave cos(k.x) against k h, and its order between small k h.
template <int d>
void wave_errors_against_h(report::Run& run, plot::Panel& panel,
                           std::vector<std::pair<std::string, double>>& orders) {
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
        panel.curve(kh, error, told_style(index++, kernel_label(K::name)));
        const double order = -report::observed_order(kh[2], error[2], kh[6], error[6]);
        run.result(std::string{K::name}, d, "rate_wave", order);
        orders.push_back({std::string{K::name}, order});
    });
}

}  // namespace

void integral_error(report::Run& run) {
    plot::Figure figure{"integral-error", 1, 3};
    figure.panel_width = 330;
    figure.share_y = true;
    std::vector<std::pair<std::string, double>> orders;
    wave_errors_against_h<1>(run, figure.at(0, 0), orders);
    wave_errors_against_h<2>(run, figure.at(0, 1), orders);
    wave_errors_against_h<3>(run, figure.at(0, 2), orders);
    run.save(figure);
    run.claim(
        "smoothing-orders",
        [&] {
            return std::all_of(orders.begin(), orders.end(), [](const auto& kernel) {
                const double expected = kernel.first == "super-gaussian" ? 4 : 2;
                return std::abs(kernel.second - expected) < 0.02;
            });
        },
        report::Needs::any_run);
}

}  // namespace sph::interpolation
