#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/figures/figures.hpp"

namespace sph::shocks {

void viscous_pressures(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    plot::Figure figure{"viscous-pressures", 1, 3};
    figure.panel_width = 300;
    const Profile exact = exact_profile(scene, 0, 0.45);
    int column = 0;
    for (const std::string name : {"von-neumann", "bulk", "monaghan-gingold"}) {
        const Method& method = tube_method(name);
        plot::Panel& v = figure.at(0, column++).titled(method.label).labels("$x$", "$v$");
        v.x_range(0, 0.45).y_range(-0.1, 1.2);
        const TubeRun tube = run_tube(scene, method);
        v.curve(exact.x, exact.v, exact_line());
        v.points(tube.profile.x, tube.profile.v, dots(style_of(name)));
        v.legend.shown = false;
        double worst = 0;  // between the contact and the shock, half a shock's width away from both
        for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
            const double x = tube.profile.x[i];
            if (x > 0.2 && x < 0.32)
                worst = std::max(worst, std::abs(tube.profile.v[i] / tube.exact.v[i] - 1));
        }
        run.result(name, static_cast<long>(scene.n), "velocity_noise", worst);
        run.fill("noise-" + name, report::number(100 * worst, 1));
    }
    run.save(figure);
}

void kernels(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    plot::Figure figure{"kernels", 1, 2};
    plot::Panel& rho = figure.at(0, 0).labels("$x$", "ρ").x_range(0.1, 0.4);
    plot::Panel& v = figure.at(0, 1).labels("$x$", "$v$").x_range(0.1, 0.4);
    report::Table table{{"kernel, Monaghan–Gingold viscosity", "h/dx", "ρ %", "v %", "P %", "u %", "pairs"}};
    std::vector<Method> methods = kernel_methods();
    methods.push_back(tube_method("monaghan-gingold"));
    methods.back().label = "cubic spline";
    std::size_t colour = 0;
    const Profile exact = exact_profile(scene, 0.1, 0.4);
    rho.curve(exact.x, exact.rho, exact_line());
    v.curve(exact.x, exact.v, exact_line());
    for (const Method& method : methods) {
        const TubeRun tube = run_tube(scene, method);
        static constexpr std::array markers{plot::Marker::circle, plot::Marker::cross, plot::Marker::square};
        const plot::Style style = dots({.label = method.label,
                                        .colour = plot::cycle(colour),
                                        .marker = markers[colour],
                                        .filled = false},
                                       4);
        ++colour;
        rho.points(tube.profile.x, tube.profile.rho, style);
        v.points(tube.profile.x, tube.profile.v, style);
        const auto n = static_cast<long>(scene.n);
        run.result(method.name, n, "l1_rho", tube.l1_rho);
        run.result(method.name, n, "l1_v", tube.l1_v);
        run.result(method.name, n, "l1_p", tube.l1_p);
        run.result(method.name, n, "pairs", static_cast<double>(tube.counters.pairs));
        table.row({method.label, report::number(method.h_over_dx, 3), report::number(100 * tube.l1_rho, 2),
                   report::number(100 * tube.l1_v, 2), report::number(100 * tube.l1_p, 2),
                   report::number(100 * tube.l1_u, 2),
                   report::number(static_cast<double>(tube.counters.pairs), 2)});
    }
    rho.legend.shown = false;
    v.legend.outside = true;
    run.save(figure);
    run.fill("kernels", table.markdown());
}

}  // namespace sph::shocks
