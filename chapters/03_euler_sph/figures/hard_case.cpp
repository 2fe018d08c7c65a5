#include "chapters/03_euler_sph/scenes/rarefaction.hpp"
#include "chapters/03_euler_sph/scenes/star_energy.hpp"
#include "common/exact/toy_star_modes.hpp"

namespace sph::euler {
void hard_case(report::Run& run) {
    plot::Figure figure{"hard-case", 1, 2};
    plot::Panel& left =
        figure.at(0, 0).titled("centre of mass of a star alone in space").labels("Ω$t$", "centre / radius");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("frequency of the star's pulsation")
                             .labels("particles $N$", "| ω / ω_{exact} − 1 |");
    StarScene scene;
    scene.n = 100;
    scene.spacing = Spacing::masses;
    const CentreRun centres = run_centres(scene, 0.2, run.quick() ? 20 : 200);
    left.curve(centres.t, centres.centre, {.label = "force (3.5)", .colour = plot::cycle(1)});
    left.curve(centres.conserving_t, centres.conserving_centre,
               {.label = "force (5.8)", .colour = plot::cycle(0)});
    double farthest = 0;
    for (const double x : centres.centre) farthest = std::max(farthest, std::abs(x));
    run.record("force 3.5", 100, {{"momentum_drift", centres.momentum}, {"farthest_centre", farthest}});
    double cured = 0;
    for (const double x : centres.conserving_centre) cured = std::max(cured, std::abs(x));
    run.record("force 5.8", 100,
               {{"momentum_drift", centres.conserving_momentum}, {"farthest_centre", cured}});
    run.fill("walk", report::number(farthest, 1));
    run.fill("walk-cured", cured < 1e-12 ? "10⁻¹²" : report::number(cured, 1));

    const std::vector<std::size_t> sizes =
        run.quick() ? std::vector<std::size_t>{50, 100} : std::vector<std::size_t>{50, 100, 200, 400};
    scene.spacing = Spacing::even;
    report::Table table{{"constant h = 1.2 mean spacings", "N = 50", "N = 100", "N = 200", "N = 400"}};
    std::vector<std::string> pulsation{"star: frequency of mode 2"}, own_h{"the same, own h, mode 3"},
        thin{"rarefaction: v"}, thin_cured{"the same, own h"};
    plot::Values n, fixed, consistent;
    for (const std::size_t size : sizes) {
        scene.n = size;
        const double constant =
            star_frequencies(scene, {"fixed-h", "cubic", 1.2}, 3)[1] / exact::toy_star_frequency(2, 2) - 1;
        const double own =
            star_frequencies(scene, {"consistent-h", "cubic", 1.2}, 3)[2] / exact::toy_star_frequency(2, 3) -
            1;
        n.push_back(static_cast<double>(size));
        fixed.push_back(std::abs(constant));
        consistent.push_back(std::abs(own));
        run.record("fixed-h mode=2", size, {{"omega_error", constant}});
        run.record("consistent-h mode=3", size, {{"omega_error", own}});
        pulsation.push_back(report::number(constant, 2));
        own_h.push_back(report::number(own, 2));
        RarefactionScene gas;
        gas.n = size;
        thin.push_back(report::number(run_rarefaction(gas, {"fixed-h", "cubic", 1.2}).velocity_error, 2));
        thin_cured.push_back(
            report::number(run_rarefaction(gas, {"consistent-h", "cubic", 1.2}).velocity_error, 2));
    }
    right.curve(n, fixed,
                {.label = "constant $h$, mode 2", .colour = plot::cycle(1), .marker = plot::Marker::square});
    right.curve(n, consistent,
                {.label = "own $h$, mode 3", .colour = plot::cycle(0), .marker = plot::Marker::circle});
    run.save(figure);
    if (run.quick()) return;
    for (const auto& row : {pulsation, own_h, thin, thin_cured}) table.row(row);
    run.fill("hard-case", table.markdown());
}

}  // namespace sph::euler
