#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/figures/tubes.hpp"
#include "common/plot/looks.hpp"

/// Figures 15 and 16 of Monaghan (2005) in their own set-up: 800 + 100 particles, alpha = 1, beta = 2, a
/// smoothed start; and the claim that what the shock leaves is right within 1 %.
namespace sph::shocks {
namespace {

/// The mean relative error of f between contact and shock, a tenth of their distance away from both.
double mean_behind_shock(const TubeRun& tube, const ExactTube& exact, Column Profile::*f) {
    const double shock = exact.jumps.front(), margin = 0.1 * (shock - exact.contact);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i) {
        const double x = tube.profile.x[i];
        if (x < exact.contact + margin || x > shock - margin) continue;
        sum += (tube.profile.*f)[i] / (tube.exact.*f)[i] - 1, ++count;
    }
    return sum / count;
}

}  // namespace

void review_tube(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 900;
    scene.threads = run.threads();
    // Half the largest spacing, which is on the right: equal masses m = (rho_L + rho_R)/2 L/N, L = 1.
    const double m = (scene.left.rho + scene.right.rho) / 2 / static_cast<double>(scene.n);
    scene.smoothing = 0.5 * m / scene.right.rho;
    const Method<1>& method = tube_methods()["alpha-beta"];
    const ExactTube exact = gas_tube(scene).exact;
    const Profile line = exact_profile(scene);
    plot::Figure figure{"review-tube", 1, 2};
    plot::Panel& u = figure.at(0, 0).labels("$x$", "$u$");
    plot::Panel& v = figure.at(0, 1).labels("$x$", "$v$");
    const TubeRun tube = run_tube(scene, method);
    for (const auto& [panel, f] : {std::pair{&u, &Profile::u}, {&v, &Profile::v}}) {
        panel->points(tube.profile.x, tube.profile.*f, plot::dots(method.styled(), 3));
        panel->curve(line.x, line.*f, plot::exact());
    }
    v.legend.shown = false;
    run.save(figure);

    TubeScene sharp = scene;
    sharp.smoothing = 0;
    const TubeRun jump = run_tube(sharp, method);
    report::Table table{{"start", "ρ %", "v %", "P %", "u %", "spike of P %"}};
    double worst = 0;
    for (const auto& [name, one] : {std::pair{"smoothed", &tube}, {"jump", &jump}}) {
        std::vector<std::string> row{name};
        for (const auto& [quantity, f] :
             {std::pair{"rho", &Profile::rho}, {"v", &Profile::v}, {"p", &Profile::p}, {"u", &Profile::u}}) {
            const double error = mean_behind_shock(*one, exact, f);
            if (one == &tube) worst = std::max(worst, std::abs(error));
            run.result(name, static_cast<long>(scene.n), std::string{"post_shock_"} + quantity, error);
            row.push_back(report::fixed(100 * error, 1));
        }
        row.push_back(report::percent(one->wiggle));
        table.row(row);
    }
    run.fill("review-tube", table.markdown());
    run.claim("smoothing-halves", [&] { return tube.wiggle < jump.wiggle / 2; });
    run.claim("review-within-one-percent", [&] { return worst < 0.01; });
}

}  // namespace sph::shocks
