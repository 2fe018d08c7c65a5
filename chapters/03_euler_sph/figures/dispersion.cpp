#include "chapters/03_euler_sph/dispersion.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::euler {
namespace {

struct Rule {
    std::string name, label;
    double Dispersion::*omega2;
};
std::vector<Rule> rules() {
    return {{"fixed-h", "one $h$", &Dispersion::fixed_h},
            {"without-omega", "$h$ ∝ 1/ρ, without $Ω_{h}$", &Dispersion::without_omega},
            {"consistent-h", "$h$ ∝ 1/ρ, with $Ω_{h}$", &Dispersion::variable_h}};
}

}  // namespace

void dispersion_figure(report::Run& run) {
    constexpr double gamma = 5.0 / 3, h = 1.2;
    plot::Figure figure{"dispersion", 1, 2};
    plot::Panel& left = figure.at(0, 0)
                            .titled("cubic spline, $h$ = 1.2 d$x$, γ = 5/3")
                            .labels("$k$ d$x$ / π", "ω^{2} d$x$^{2} / $c_{s}$^{2}");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("Gaussian, $h$ = 1.5 d$x$, γ = 2")
                             .labels("$k$ d$x$ / π", "| ω^{2} / ($c_{s}k$)^{2} − 1 |");
    plot::Values k, exact;
    for (int n = 1; n <= 100; ++n) {
        k.push_back(n / 100.0);
        exact.push_back(square(pi * k.back()));
    }
    left.curve(k, exact, plot::exact());
    left.y_range(0, 4);
    const std::vector<int> waves =
        run.quick() ? std::vector{1, 16, 32} : std::vector{1, 4, 8, 12, 16, 20, 24, 28, 31};
    double worst = 0;
    std::size_t index = 0;
    for (const Rule& rule : rules()) {
        plot::Values line, dots_k, dots_y, small_k, small;
        for (const double share : k)
            line.push_back(dispersion<CubicSpline<1>>(h, gamma, pi * share).*rule.omega2);
        for (const int n : waves) {
            WaveScene scene;
            scene.waves = n;
            scene.gamma = gamma;
            scene.courant = 0.1;
            const double dx2 = square(scene.spacing());
            const double omega2 = measured_omega2(scene, {rule.name, "cubic", h}) * dx2;
            const double formula = dispersion<CubicSpline<1>>(h, gamma, 2 * pi * n / 64).*rule.omega2;
            dots_k.push_back(n / 32.0);
            dots_y.push_back(omega2);
            worst = std::max(worst, std::abs(omega2 / formula - 1));
            run.record(rule.name + " k=" + std::to_string(n) + "/32 pi", 64,
                       {{"omega2", omega2, "c_s^2/dx^2"}});
        }
        const plot::Style style = plot::line(plot::look_of(rule.name, rule.label));
        left.curve(k, line, style);
        left.points(dots_k, dots_y,
                    {.label = index == 2 ? "simulations" : "",
                     .colour = style.colour,
                     .marker = plot::Marker::circle,
                     .marker_size = 4});
        for (int n = 1; n <= 30; ++n) {
            small_k.push_back(0.01 * std::pow(30.0, n / 30.0));
            const double K2 = square(pi * small_k.back());
            small.push_back(
                std::abs(dispersion<Gaussian<1>>(1.5, 2, pi * small_k.back()).*rule.omega2 / K2 - 1));
        }
        right.curve(small_k, small, style);
        ++index;
    }
    right.legend.shown = false;
    right.slope(2, 0.02, 0.05, 5e-3, "order 2");
    right.slope(4, 0.05, 0.15, 2e-6, "order 4");
    run.save(figure);
    run.record("simulated against formula", 64, {{"largest_relative_difference", worst}});
    run.fill("dispersion-worst", worst < 1e-6 ? "10⁻⁶" : report::number(worst, 1));
    const double k_small = pi / 32;
    report::Table table{{"kernel, h = 1.2 dx, k dx = π/32", "one $h$", "with $Ω_{h}$", "without $Ω_{h}$"}};
    for (const std::string name : {"cubic", "quintic", "super-gaussian"}) {
        with_kernel<1>(name, [&](const auto& kernel) {
            const auto d = dispersion<std::decay_t<decltype(kernel)>>(h, gamma, k_small);
            std::vector<std::string> row{name};
            for (const double omega2 : {d.fixed_h, d.variable_h, d.without_omega})
                row.push_back(report::fixed(std::sqrt(omega2) / k_small, 5));
            table.row(row);
        });
    }
    run.fill("dispersion", table.markdown());
    run.claim("formula-is-measured", [&] { return worst < 1e-6; });
    run.claim("lucky-gammas", [&] {
        bool all = true;
        const std::array lucky{&Dispersion::fixed_h, &Dispersion::without_omega, &Dispersion::variable_h};
        for (std::size_t n = 0; n < 3; ++n) {
            for (int g = 1; g <= 3; ++g) {
                const auto error = [&](double k_dx) {
                    return std::abs(dispersion<Gaussian<1>>(1.5, g, k_dx).*lucky[n] / square(k_dx) - 1);
                };
                const double order = std::log2(error(0.2) / error(0.1));
                all = all && std::abs(order - (static_cast<int>(n) + 1 == g ? 4 : 2)) < 0.2;
            }
        }
        return all;
    });
    run.claim("one-h-can-be-faster", [&] {
        const Dispersion d = dispersion<CubicSpline<1>>(h, gamma, k_small);
        return d.fixed_h > d.variable_h && std::sqrt(d.fixed_h) / k_small > 1.02;
    });
}

}  // namespace sph::euler
