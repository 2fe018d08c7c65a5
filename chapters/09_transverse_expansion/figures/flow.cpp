#include <algorithm>
#include <cmath>

#include "chapters/09_transverse_expansion/scenes/event.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {

/// Shape of the beginning against flow at the end, event by event.
void flow(report::Run& run) {
    const int events = run.quick() ? 3 : 16;
    std::array<plot::Values, 2> eps, v;
    for (int seed = 1; seed <= events; ++seed) {
        const EventRun one = run_event(
            {.seed = static_cast<std::uint64_t>(seed), .n = run.quick() ? 500UL : 1500UL, .times = {8}});
        for (std::size_t k = 0; k < 2; ++k)
            eps[k].push_back(one.eccentricity[k]), v[k].push_back(one.flow[k]);
        run.record("seed=" + std::to_string(seed), one.frames.back().x.size(),
                   {{"eps_2", one.eccentricity[0]},
                    {"v_2", one.flow[0]},
                    {"eps_3", one.eccentricity[1]},
                    {"v_3", one.flow[1]}});
    }
    plot::Figure figure{"flow", 1, 2};
    std::array<double, 2> response{}, correlation{};
    for (std::size_t k = 0; k < 2; ++k) {
        double xy = 0, xx = 0, x = 0, y = 0, yy = 0;
        const auto n = static_cast<double>(events);
        for (std::size_t i = 0; i < eps[k].size(); ++i) {
            xy += eps[k][i] * v[k][i], xx += square(eps[k][i]), yy += square(v[k][i]);
            x += eps[k][i], y += v[k][i];
        }
        response[k] = xy / xx;
        correlation[k] =
            (xy / n - x * y / n / n) / std::sqrt((xx / n - x * x / n / n) * (yy / n - y * y / n / n));
        const std::string number = std::to_string(k + 2);
        plot::Panel& panel =
            figure.at(0, static_cast<int>(k)).labels("ε_{" + number + "}", "$v$_{" + number + "}");
        const double end = 1.1 * *std::max_element(eps[k].begin(), eps[k].end());
        panel.x_range(0, end).y_range(0, 1.3 * response[k] * end);
        panel.points(
            eps[k], v[k],
            plot::dots({.label = "events", .colour = plot::cycle(0), .marker = plot::Marker::circle}, 5));
        panel.curve({0, end}, {0, response[k] * end},
                    {.label = "$v$ = " + report::number(response[k], 2) + " ε",
                     .colour = plot::Colour{0.5, 0.5, 0.5}});
        run.record("response", static_cast<std::size_t>(events),
                   {{"v_over_eps_" + number, response[k]}, {"correlation_" + number, correlation[k]}});
        run.fill("response-" + number, report::number(response[k], 2));
        run.fill("correlation-" + number, report::fixed(correlation[k], 2));
    }
    run.save(figure);
    run.claim("flow-follows-shape", [&] { return correlation[0] > 0.6 && correlation[1] > 0.6; });
}

}  // namespace sph::transverse
