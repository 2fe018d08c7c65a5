#include <cmath>
#include <map>

#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {

/// The error of the time step alone, by both Runge-Kutta methods.
void order(report::Run& run) {
    const Flow flow = gubser(1, 1);
    const std::size_t n = run.quick() ? 300 : 1500;
    const auto final = [&](Order by, long steps) {
        return run_plane(flow, {.n = n, .times = {1.5}, .order = by, .steps = steps},
                         plane_methods().recommended())
            .back();
    };
    const Snapshot reference = final(Order::fourth, 256);
    plot::Figure figure{"order"};
    plot::Panel& axes = figure.panel().log_log().labels("dτ", "$L$_{1} of ε against 256 steps");
    std::map<Order, plot::Values> errors;
    const std::vector<long> steps{8, 16, 32, 64};
    plot::Values dt;
    for (const long count : steps) dt.push_back(0.5 / static_cast<double>(count));
    for (const Order by : {Order::second, Order::fourth}) {
        for (const long count : steps) {
            const Snapshot shot = final(by, count);
            double difference = 0, whole = 0;
            for (std::size_t i = 0; i < shot.r.size(); ++i) {
                if (reference.r[i] >= flow.window) continue;
                difference += reference.area[i] * std::abs(shot.eps[i] - reference.eps[i]);
                whole += reference.area[i] * reference.eps[i];
            }
            errors[by].push_back(difference / whole);
            run.record(by == Order::second ? "rk2" : "rk4", static_cast<std::size_t>(count),
                       {{"l1_eps", difference / whole}});
        }
        axes.curve(dt, errors[by],
                   {.label = by == Order::second ? "midpoint rule" : "Runge–Kutta 4",
                    .colour = plot::cycle(by == Order::second ? 1 : 0),
                    .marker = plot::Marker::circle});
    }
    axes.curve({dt.front(), dt.back()}, {reference.l1_eps, reference.l1_eps},
               {.label = "error of the particles",
                .colour = plot::Colour{0.5, 0.5, 0.5},
                .dash = plot::Dash::dashed});
    axes.slope(2, dt.back(), dt.front(), errors[Order::second].back() / 2, "order 2");
    run.save(figure);
    const auto rate = [&](Order by) { return std::log2(errors[by][2] / errors[by][3]); };
    run.record("rk2", n, {{"rate_l1_eps", rate(Order::second)}});
    run.record("rk4", n, {{"rate_l1_eps", rate(Order::fourth)}});
    run.claim("second-order", [&] { return rate(Order::second) > 1.8 && rate(Order::second) < 2.3; });
    run.claim("fourth-order", [&] { return rate(Order::fourth) > 3.3; });
    run.claim("step-is-free", [&] { return errors[Order::fourth].front() < reference.l1_eps; });
}

}  // namespace sph::transverse
