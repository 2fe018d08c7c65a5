#include "chapters/03_euler_sph/external.hpp"
#include "chapters/03_euler_sph/resolution.hpp"
#include "chapters/03_euler_sph/figures/figures.hpp"

namespace sph::euler {
namespace {

using K = CubicSpline<2>;
template <class Smoothing, class... E>
using Listed =
    ParticlesOf<2, Union<List<Position>, typename Effects<Smoothing, E...>::ReadI,
                         typename Effects<Smoothing, E...>::ReadJ, typename Effects<E...>::Stored>>;

/// Nanoseconds a pair of one pass with only the listed effects, over neighbours that are found. The particles
/// hold only the columns that these name.
template <class Smoothing, class... E>
double ns_a_pair(report::Run& run, const Smoothing& smoothing, const E&... effects) {
    const std::size_t per_side = 64;
    const double h = 1.3 / static_cast<double>(per_side);
    Listed<Smoothing, E...> p{per_side * per_side};
    p.for_each_column([](auto, Column& column) { std::fill(column.begin(), column.end(), 1.0); });
    p.x = make_points<2>(Arrangement::jittered, per_side, 0.2, 1);
    if constexpr (requires { p.h[0]; }) p.h.assign(p.size(), h);
    Neighbours<2, Box<2>> neighbours{periodic_unit_box<2>()};
    neighbours.find(p.x, K::support * h);
    const report::Timing timing =
        run.time([&] { sum_over_neighbours(p, neighbours, smoothing, Effects{effects...}); });
    return 1e9 * timing.best / static_cast<double>(neighbours.pairs());
}

struct Cost {
    std::string label;
    double ns;
};

}  // namespace

void cost_of_effects(report::Run& run) {
    const double h = 1.3 / 64;
    const ConstantH<K> one{h};
    const BothH<K> both{};
    const std::vector<Cost> costs{
        {"density", ns_a_pair(run, one, SummedDensity{})},
        {"density and its slope with own h", ns_a_pair(run, OwnH<K>{}, SummedDensity{}, DensitySlope{})},
        {"pressure (3.8)", ns_a_pair(run, one, PressureForce<>{})},
        {"pressure (3.8) and linear force", ns_a_pair(run, one, PressureForce<>{}, LinearForce{1})},
        {"pressure (5.32)", ns_a_pair(run, one, PressureForce<PhiIsOne>{})},
        {"pressure (5.36)", ns_a_pair(run, one, PressureForce<PhiIsRootPressure>{})},
        {"pressure (3.8) and heating", ns_a_pair(run, one, PressureForce<>{}, CompressionHeating<>{})},
        {"pressure (3.8) with heating and work",
         ns_a_pair(run, one, PressureForce<>{}, CompressionHeating<>{}, Work{})},
        {"pressure (5.8) with both h", ns_a_pair(run, both, GradHForce{})},
        {"pressure (5.8) and heating", ns_a_pair(run, both, GradHForce{}, GradHHeating{})}};
    plot::Figure figure{"cost-of-effects"};
    plot::Panel& panel = figure.panel()
                             .titled("2D, cubic spline, $h$ = 1.3 d$x$, one core")
                             .labels("CPU time a pair [ns]", "");
    report::Table table{{"listed", "ns a pair"}};
    plot::Values at;
    for (std::size_t k = 0; k < costs.size(); ++k) {
        const double y = static_cast<double>(costs.size() - k);
        at.push_back(y);
        panel.y.tick_names.push_back(costs[k].label);
        panel.band({0, costs[k].ns}, {y - 0.3, y - 0.3}, {y + 0.3, y + 0.3}).colour = plot::cycle(0);
        run.result(costs[k].label, 4096, "cpu_ns_per_pair", costs[k].ns, "ns");
        table.row({costs[k].label, report::timing(costs[k].ns)});
    }
    panel.y.ticks = at;
    panel.x.range =
        std::array{0.0, 1.1 * std::max_element(costs.begin(), costs.end(), [](const Cost& a, const Cost& b) {
                                  return a.ns < b.ns;
                              })->ns};
    panel.grid = false;
    run.save(figure);
    run.fill("cost-of-effects", table.markdown());
}

}  // namespace sph::euler
