#include <algorithm>

#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "chapters/04_artificial_viscosity/switches.hpp"

namespace sph::shocks {
namespace {

using K = CubicSpline<2>;
template <class... E>
using Listed = ParticlesOf<2, Union<List<Position, SmoothingLength>, typename Effects<BothH<K>, E...>::ReadI,
                                    typename Effects<BothH<K>, E...>::ReadJ, typename Effects<E...>::Stored>>;

struct Cost {
    std::string label;
    double ns = 0;
    std::size_t columns = 0;
};

/// Nanoseconds a pair of one pass with only the listed effects, over neighbours that are found. The particles
/// hold only the columns that these name.
template <class... E>
Cost measure(report::Run& run, const std::string& label, const E&... effects) {
    const std::size_t per_side = 64;
    const double h = 1.2 / static_cast<double>(per_side);
    Listed<E...> p{per_side * per_side};
    std::size_t columns = 0;
    p.for_each_column([&](auto, Column& column) {
        std::fill(column.begin(), column.end(), 1.0);
        ++columns;
    });
    p.x = make_points<2>(Arrangement::jittered, per_side, 0.2, 1);
    p.h.assign(p.size(), h);
    Neighbours<2, Box<2>> neighbours{periodic_unit_box<2>()};
    neighbours.find(p.x, K::support * h);
    const report::Timing timing =
        run.time([&] { sum_over_neighbours(p, neighbours, BothH<K>{}, Effects{effects...}); });
    return {label, 1e9 * timing.best / static_cast<double>(neighbours.pairs()), columns};
}

}  // namespace

void cost_of_effects(report::Run& run) {
    using Switched = Scaled<SignalViscosity, ViscosityAlpha>;
    const GradHForce force;
    const GradHHeating heat;
    const std::vector<Cost> costs{
        measure(run, "pressure", force),
        measure(run, "pressure and α-β viscosity", force, ViscousForce<AlphaBeta>{}),
        measure(run, "pressure and signal viscosity", force, ViscousForce<SignalViscosity>{}),
        measure(run, "pressure and signal viscosity with own α", force, ViscousForce<Switched>{}),
        measure(run, "pressure and reconstructed viscosity", force, ViscousForce<ReconstructedViscosity>{}),
        measure(run, "pressure heating", heat),
        measure(run, "pressure and α-β heating", heat, ViscousHeating<AlphaBeta>{}),
        measure(run, "pressure and reconstructed heating", heat, ViscousHeating<ReconstructedViscosity>{}),
        measure(run, "the same and conduction", heat, ViscousHeating<ReconstructedViscosity>{},
                Conduction<ContactSpeed>{}),
        measure(run, "gradient of $v$", VelocityGradient{}),
        measure(run, "gradients of $v$ and $P$", VelocityGradient{}, PressureGradient{}),
        measure(run, "limit of the time step", SignalRate{}),
    };
    plot::Figure figure{"cost-of-effects"};
    plot::Panel& panel = figure.panel()
                             .titled("2D, cubic spline, own $h$ = 1.2 d$x$, one core")
                             .labels("CPU time a pair [ns]", "");
    report::Table table{{"listed", "columns of a particle", "ns a pair"}};
    double largest = 0;
    for (std::size_t k = 0; k < costs.size(); ++k) {
        const double y = static_cast<double>(costs.size() - k);
        panel.y.ticks.push_back(y);
        panel.y.tick_names.push_back(costs[k].label);
        panel.band({0, costs[k].ns}, {y - 0.3, y - 0.3}, {y + 0.3, y + 0.3}).colour = plot::cycle(0);
        run.result(costs[k].label, 4096, "cpu_ns_per_pair", costs[k].ns, "ns");
        run.result(costs[k].label, 4096, "columns", static_cast<double>(costs[k].columns), "columns");
        table.row({costs[k].label, std::to_string(costs[k].columns), report::timing(costs[k].ns)});
        largest = std::max(largest, costs[k].ns);
    }
    panel.x.range = std::array{0.0, 1.1 * largest};
    panel.grid = false;
    run.save(figure);
    run.fill("cost-of-effects", table.markdown());
}

}  // namespace sph::shocks
