#include "chapters/04_artificial_viscosity/studies.hpp"

namespace sph::shocks {

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
    bool first = true;
    for (const Method& method : methods) {
        const TubeRun tube = run_tube(scene, method);
        if (first) {
            rho.curve(tube.exact.x, tube.exact.rho, exact_line());
            v.curve(tube.exact.x, tube.exact.v, exact_line());
            first = false;
        }
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
