#include <algorithm>
#include <map>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// A kernel of fourth order against one of second, at equal h.

namespace sph::shocks {

namespace {

report::Comparison kernel_table() {
    using namespace report;
    return {{"kernel, Monaghan–Gingold viscosity", "h/dx"},
            {{"ρ %", "l1_rho", in_percent()},
             {"v %", "l1_v", in_percent()},
             {"P %", "l1_p", in_percent()},
             {"u %", "l1_u", in_percent()},
             {"spike of P %", "wiggle_p", in_percent()},
             {"pairs", "pairs", digits(2)}}};
}

std::string with_h(const Method<1>& method) {
    return method.name + " h=" + report::number(method.h_over_dx, 3);
}

}  // namespace

void kernels(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 360;
    scene.threads = run.threads();
    plot::Figure figure{"kernels", 1, 3};
    figure.panel_width = 300;
    plot::Panel& rho = figure.at(0, 0).labels("$x$", "ρ").x_range(0.1, 0.4);
    plot::Panel& v = figure.at(0, 1).labels("$x$", "$v$").x_range(0.1, 0.4);
    plot::Panel& s = figure.at(0, 2).labels("$x$", "$P$ / ρ^{γ}").x_range(0.1, 0.4).y_range(0.9, 2.3);
    report::Comparison table = kernel_table();
    const Profile exact = exact_profile(scene, 0.1, 0.4);
    std::map<std::string, std::vector<TubeRun>> of_kernel;
    for (const Method<1>& method : kernel_methods()) {
        for (const double h : {1.0, 1.2, 1.35, 1.5}) {
            if (method.kernel == "cubic" && h != method.h_over_dx) continue;
            Method<1> one = method;
            one.h_over_dx = h;
            const TubeRun& tube = of_kernel[method.kernel].emplace_back(run_tube(scene, one));
            const auto pairs = static_cast<double>(tube.counters.pairs);
            table.add(run, with_h(one), scene.n, {method.label, report::number(h, 3)},
                      tube.errors() + report::Quantities{{"pairs", pairs}});
            if (h != 1.2) continue;
            const plot::Style look = plot::dots(method.styled(), 4);
            rho.points(tube.profile.x, tube.profile.rho, look);
            v.points(tube.profile.x, tube.profile.v, look);
            s.points(tube.profile.x, entropy_of(tube.profile, scene.gamma), look);
        }
    }
    rho.curve(exact.x, exact.rho, plot::exact());
    v.curve(exact.x, exact.v, plot::exact());
    s.curve(exact.x, entropy_of(exact, scene.gamma), plot::exact());
    rho.legend.shown = v.legend.shown = false;
    s.legend.outside = true;
    run.save(figure);
    run.fill("kernels", table.markdown());
    run.claim("super-gaussian-rings", [&] {  // both at h = 1.2 spacings
        const auto largest = [&](const char* kernel) {
            const Column entropy = entropy_of(of_kernel.at(kernel)[1].profile, scene.gamma);
            return *std::max_element(entropy.begin(), entropy.end());
        };
        return largest("super-gaussian") > largest("gaussian");
    });
    run.claim("super-gaussian-better", [&] {
        bool better = true;
        for (std::size_t k = 0; k < 4; ++k) {
            const TubeRun &fourth = of_kernel.at("super-gaussian")[k], &second = of_kernel.at("gaussian")[k];
            better = better && fourth.l1_rho < second.l1_rho && fourth.l1_v < second.l1_v &&
                     fourth.l1_p < second.l1_p && fourth.l1_u < second.l1_u && fourth.wiggle < second.wiggle;
        }
        return better;
    });
}

}  // namespace sph::shocks
