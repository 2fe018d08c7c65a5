#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::shocks {

void kernels(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    plot::Figure figure{"kernels", 1, 2};
    plot::Panel& rho = figure.at(0, 0).labels("$x$", "ρ").x_range(0.1, 0.4);
    plot::Panel& v = figure.at(0, 1).labels("$x$", "$v$").x_range(0.1, 0.4);
    using namespace report;
    Comparison table{{"kernel, Monaghan–Gingold viscosity", "h/dx"},
                     {{"ρ %", "l1_rho", in_percent()},
                      {"v %", "l1_v", in_percent()},
                      {"P %", "l1_p", in_percent()},
                      {"u %", "l1_u", in_percent()},
                      {"pairs", "pairs", digits(2)}}};
    const Profile exact = exact_profile(scene, 0.1, 0.4);
    rho.curve(exact.x, exact.rho, plot::exact());
    v.curve(exact.x, exact.v, plot::exact());
    for (const Method<1>& method : kernel_methods()) {
        const TubeRun tube = run_tube(scene, method);
        const auto pairs = static_cast<double>(tube.counters.pairs);
        rho.points(tube.profile.x, tube.profile.rho, plot::dots(method.styled(), 4));
        v.points(tube.profile.x, tube.profile.v, plot::dots(method.styled(), 4));
        table.add(run, method.name, scene.n, {method.label, number(method.h_over_dx, 3)},
                  tube.errors() + Quantities{{"pairs", pairs}});
    }
    rho.legend.shown = false;
    v.legend.outside = true;
    run.save(figure);
    run.fill("kernels", table.markdown());
}

}  // namespace sph::shocks
