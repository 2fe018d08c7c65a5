#include <algorithm>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/error_curves.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

plot::Style style_of(const ParticleSeries& series, bool twice) {
    const bool even = series.arrangement == Arrangement::even;
    return {.label = (twice ? "(1.15), " : "(1.16), ") + series.name,
            .colour = plot::cycle(twice ? 1 : 0),
            .dash = even ? plot::Dash::dashed : plot::Dash::solid,
            .marker = twice ? plot::Marker::square : plot::Marker::circle,
            .filled = !even};
}

/// Observed orders over all resolutions.
struct Orders {
    plot::Values twice;
    double brookshaw_even = 1e300;  // the least
};

/// The hard case: a sum that is differentiated twice, beside Brookshaw's form.
class SecondDerivativesFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        plot::Figure figure{"second-derivatives", 1, 2};
        report::Table table{{"particles along a side", "twice differentiated (1.15)", "Brookshaw (1.16)"}};
        Orders orders;
        compare<1>(run, figure.at(0, 0), table, orders);
        compare<2>(run, figure.at(0, 1), table, orders);
        run.save(figure);
        run.fill("second-derivatives", table.markdown());
        run.claim("twice-diverges", [&] {
            return std::all_of(orders.twice.begin(), orders.twice.end(),
                               [](double order) { return order < -1.8 && order > -2.2; });
        });
        run.claim("brookshaw-even", [&] { return orders.brookshaw_even > -0.3; });
    }

  private:
    template <int d>
    void compare(report::Run& run, plot::Panel& panel, report::Table& table, Orders& orders) const {
        panel.titled(std::to_string(d) + "D").log_log();
        panel.labels(d == 1 ? "particles $N$" : "particles along a side, $N$^{1/2}",
                     "relative $L$_{2} error of ∇^{2}$A$");
        for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {  // even, jittered
            const ParticleSeries& series = particle_series()[s];
            const ErrorCurves curves = error_curves<d>(series, options_, run);
            panel.curve(curves.n, curves.twice, style_of(series, true));
            panel.curve(curves.n, curves.laplacian, style_of(series, false));
            const auto order = [&](const plot::Values& error) {
                return report::observed_order(curves.n.front(), error.front(), curves.n.back(), error.back());
            };
            orders.twice.push_back(order(curves.twice));
            if (series.arrangement == Arrangement::even)
                orders.brookshaw_even = std::min(orders.brookshaw_even, order(curves.laplacian));
            const std::string name = series.name + "-" + std::to_string(d) + "d";
            for (const std::size_t k : {std::size_t{0}, curves.n.size() - 1}) {
                const auto n = static_cast<std::size_t>(curves.n[k]);
                table.row({std::to_string(d) + "D, " + series.name + ", " + std::to_string(n),
                           report::number(curves.twice[k], 2), report::number(curves.laplacian[k], 2)});
                run.record("twice-" + name, n, {{"l2_laplacian", curves.twice[k]}});
                run.record("brookshaw-" + name, n, {{"l2_laplacian", curves.laplacian[k]}});
            }
        }
    }

    SmoothingOptions options_;
};

}  // namespace

report::Task second_derivatives() {
    return SecondDerivativesFigure{};
}

}  // namespace sph::interpolation
