#include <map>

#include "chapters/04_artificial_viscosity/scenes/two_layer.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/words.hpp"

namespace sph::shocks {
namespace {

/// The runs of each method, one a size.
using Flows = std::map<std::string, std::vector<LayersRun>>;

Flows run_all(report::Run& run, LayersScene scene, const std::vector<std::size_t>& sizes) {
    using namespace report;
    Comparison table{{"mean of μ", "rows"},
                     {{"v %", "l1_v", digits(2, 100)},
                      {"slip, % of V", "slip", digits(2, 100)},
                      {"τ below / exact − 1 [%]", "lower_stress", decimals(1, 100)},
                      {"above", "upper_stress", decimals(1, 100)}}};
    Flows flows;
    for (const Method<2>& method : layered_methods()) {
        for (const std::size_t size : sizes) {
            scene.n = size;
            const LayersRun& flow = flows[method.name].emplace_back(run_layers(scene, method));
            table.add(run, method.name, size, {method.label, std::to_string(size)}, flow.measured());
        }
    }
    run.fill("layers", table.markdown());
    return flows;
}

/// One particle of each row: the others have the same velocity.
void draw_rows(plot::Panel& panel, const LayersScene& scene, const LayersRun& flow, const plot::Style& look) {
    plot::Values y, v;
    for (std::size_t i = 0; i < flow.y.size(); i += scene.columns)
        y.push_back(flow.y[i]), v.push_back(flow.v[i]);
    panel.points(y, v, look);
}

void draw(report::Run& run, const LayersScene& scene, const Flows& flows,
          const std::vector<std::size_t>& sizes) {
    plot::Figure figure{"layers", 1, 2};
    plot::Panel& profile = figure.at(0, 0).labels("$y$ / $L$", "$v$_{x} / $V$");
    plot::Panel& errors =
        figure.at(0, 1).log_log().labels("rows from wall to wall", "relative $L$_{1} error of $v$");
    for (const Method<2>& method : layered_methods()) {
        draw_rows(profile, scene, flows.at(method.name).back(), method.styled());
        plot::Values error;
        for (const LayersRun& flow : flows.at(method.name)) error.push_back(flow.l1_v);
        errors.curve({sizes.begin(), sizes.end()}, error, method.styled());
    }
    const exact::TwoLayer exact = scene.solution();
    plot::draw_exact(profile, 0, 1, [&](double y) { return exact.at(y).v; });
    errors.x.ticks.assign(sizes.begin(), sizes.end());
    errors.legend.shown = false;
    run.save(figure);
}

/// The thickness that the slip takes from the lower layer, in smoothing lengths.
double missing(const LayersScene& scene, const LayersRun& flow) {
    const double slope = scene.solution().at(0).tau / scene.viscosity;
    return -flow.slip / slope * static_cast<double>(scene.n) / layered_methods().recommended().h_over_dx;
}

}  // namespace

void layers(report::Run& run) {
    LayersScene scene;
    scene.threads = run.threads();
    if (run.quick()) scene.fadings = 2;
    const auto sizes = run.sizes({16, 20}, {16, 20, 24});
    const Flows flows = run_all(run, scene, sizes);
    scene.n = sizes.back();
    draw(run, scene, flows, sizes);
    run.claim("layers-harmonic", [&] {
        const auto &harmonic = flows.at("layered"), &arithmetic = flows.at("layered-arithmetic");
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            if (arithmetic[k].l1_v < 8 * harmonic[k].l1_v) return false;  // measured: 10.8, 11.3, 11.8
        }
        const double of_h = missing(scene, arithmetic.back());
        if (of_h < 0.27 || of_h > 0.4) return false;  // measured: 0.32
        return harmonic.back().l1_v < 0.75 * harmonic.front().l1_v &&
               arithmetic.back().l1_v < 0.75 * arithmetic.front().l1_v;
    });
    scene.walls = Walls::rigid;
    const double rigid = run_layers(scene, layered_methods().recommended()).l1_v;
    run.result("layered", static_cast<long>(scene.n), "rigid_walls_l1_v", rigid);
    run.fill("layers-rigid", report::number(100 * rigid, 2));
}

}  // namespace sph::shocks
