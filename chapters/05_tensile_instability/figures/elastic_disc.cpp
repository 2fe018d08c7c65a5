#include "chapters/05_tensile_instability/scenes/elastic_disc.hpp"

#include <map>

#include "common/report/comparison.hpp"

namespace sph::tensile {

void elastic_disc(report::Run& run) {
    plot::Figure figure{"elastic-disc", 1, 3};
    figure.panel_width = 330;
    using namespace report;
    // What a run of torn matter does has few digits that another compiler would repeat.
    const auto about = [](double share) -> std::string {
        return share < 0.2 ? "below 20 %" : share > 1.1 ? "more than at first" : fixed(100 * share, 0) + " %";
    };
    Comparison table{{"stress"},
                     {{"pieces", "pieces", [](double n) { return n > 1 ? "more than 1" : fixed(n, 0); }},
                      {"came to t", "time", decimals(0)},
                      {"energy left", "energy_left", about}}};
    std::map<std::string, ElasticDiscRun> runs;
    int column = 0;
    for (const SolidMethod& method :
         solid_methods().named({"jaumann", "artificial-stress", "corrected-rate", "total-lagrangian"})) {
        ElasticDiscScene scene;
        scene.threads = run.threads();
        if (run.quick()) scene.n = 200, scene.time = 10;
        const ElasticDiscRun& disc = runs[method.name] = run_elastic_disc(scene, method);
        table.add(run, method.name, scene.n, {method.label}, disc.measured());
        if (method.law == Law::corrected_rate) continue;
        plot::Panel& panel = figure.at(0, column++).titled(method.label).labels("$x$", "$y$");
        panel.equal_aspect = true;
        panel.particles({.name = method.name,
                         .x = disc.x[0],
                         .y = disc.x[1],
                         .value = disc.radius,
                         .bar = {.label = "radius at first", .shown = false}});
    }
    run.save(figure);
    run.fill("elastic-disc", table.markdown());
    const bool breaks = runs["jaumann"].pieces.count > 2 && runs["jaumann"].largest_share < 0.9;
    const bool whole =
        runs["artificial-stress"].pieces.count == 1 && runs["total-lagrangian"].pieces.count == 1;
    run.claim("disc-breaks", [&] { return breaks; });
    run.claim("disc-whole", [&] { return whole; });
    run.claim("disc-answer", [&] { return breaks && whole; });
    run.claim("disc-price", [&] {
        return runs["artificial-stress"].energy_left < 0.2 &&
               std::abs(runs["total-lagrangian"].energy_left - 1) < 0.03;
    });
}

}  // namespace sph::tensile
