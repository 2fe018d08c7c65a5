#include "chapters/04_artificial_viscosity/figures/tubes.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// The contact of Sod's tube: a spike of pressure as wide as the kernel, and what conduction makes of it.
namespace sph::shocks {
namespace {

/// The same spike at three resolutions: places in spacings of the particles on the right.
std::vector<double> spikes(report::Run& run, plot::Panel& panel) {
    const Method<1>& method = tube_methods()["alpha-beta"];
    std::vector<double> wiggles;
    std::size_t k = 0;
    for (const std::size_t n : run.sizes({90, 180}, {360, 720, 1440})) {
        TubeScene scene;
        scene.n = n;
        const TubeRun tube = run_tube(scene, method);
        const ExactTube exact = gas_tube(scene).exact;
        const double dx = (1 + scene.right.rho) / 2 / static_cast<double>(n) / scene.right.rho;
        plot::Values x, p;
        for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
            x.push_back((tube.profile.x[i] - exact.contact) / dx);
            p.push_back(tube.profile.p[i] / exact.p_star);
        }
        panel.curve(
            x, p,
            {.label = "$N$ = " + std::to_string(n),
             .colour = plot::cycle(std::array{4, 5, 9}[k]),  // no method's of the other panels
             .marker = std::array{plot::Marker::circle, plot::Marker::square, plot::Marker::diamond}[k],
             .marker_size = 4});
        wiggles.push_back(tube.wiggle);
        ++k;
    }
    panel.curve({-6, 6}, {1, 1}, plot::exact());
    return wiggles;
}

report::Comparison contact_table() {
    using namespace report;
    return {{"method"},
            {{"spike of P %", "wiggle_p", in_percent()},
             {"ρ %", "l1_rho", in_percent()},
             {"u %", "l1_u", in_percent()}}};
}

}  // namespace

void contact(report::Run& run) {
    plot::Figure figure{"contact", 1, 3};
    figure.panel_width = 300;
    plot::Panel& scaled = figure.at(0, 0)
                              .titled("α = 1, β = 2")
                              .labels("($x$ − $x$_{contact}) / d$x$", "$P$ / $P$*")
                              .x_range(-6, 6)
                              .y_range(0.85, 1.2);
    const std::vector<double> wiggles = spikes(run, scaled);
    TubeScene scene;
    scene.n = run.quick() ? 90 : 720;
    scene.threads = run.threads();
    const Profile line = exact_profile(scene, 0.1, 0.26);
    plot::Panel& p = figure.at(0, 1).labels("$x$", "$P$").x_range(0.1, 0.26).y_range(0.28, 0.36);
    plot::Panel& u = figure.at(0, 2).labels("$x$", "$u$").x_range(0.1, 0.26);
    report::Comparison table = contact_table();
    std::vector<TubeRun> runs;
    for (const Method<1>& method : tube_methods().named({"alpha-beta", "thermokinetic", "thermokinetic-all",
                                                         "price", "reconstructed", "reconstructed-cubic"})) {
        const TubeRun& tube = runs.emplace_back(run_tube(scene, method));
        table.add(run, method.name, scene.n, {method.label}, tube.errors());
        if (method.name == "price" || method.name == "thermokinetic-all" ||
            method.name == "reconstructed-cubic")
            continue;
        p.points(tube.profile.x, tube.profile.p, plot::dots(method.styled(), 3.5));
        u.points(tube.profile.x, tube.profile.u, plot::dots(method.styled(), 3.5));
    }
    p.curve(line.x, line.p, plot::exact());
    u.curve(line.x, line.u, plot::exact());
    p.legend.shown = false;
    u.legend.outside = true;
    run.save(figure);
    run.fill("contact", table.markdown());
    run.claim("spike-stays", [&] {
        return wiggles.back() > 0.8 * wiggles.front() && wiggles.back() < 1.25 * wiggles.front();
    });
    run.claim("conduction-costs-contact",
              [&] { return runs[1].wiggle < runs[0].wiggle / 5 && runs[1].l1_rho > 1.3 * runs[0].l1_rho; });
    run.claim("contact-recommended", [&] {
        const TubeRun &price = runs[3], &best = runs[4];
        return best.wiggle < 0.2 * runs[0].wiggle && best.l1_rho < price.l1_rho;
    });
}

}  // namespace sph::shocks
