#include <cmath>

#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::transverse {

/// Gubser's flow: energy density and velocity at three times.
void gubser_profiles(report::Run& run) {
    const std::size_t n = run.quick() ? 1000 : 10000;
    plot::Figure figure{"gubser", 1, 2};
    plot::Panel& eps = figure.at(0, 0).labels("$r$", "ε").x_range(0, 4).log_y().y_range(1e-3, 2);
    plot::Panel& error = figure.at(0, 1).labels("$r$", "ε/ε_{exact} – 1, %").x_range(0, 2.5).y_range(-2, 2);
    error.legend.shown = false;
    report::Table table{{"q", "τ", "L1 of ε %", "L1 of u %", "steps", "CPU s"}};
    double worst_eps = 0, worst_u = 0, seconds = 0, other = 0;
    for (const double q : {1.0, 0.5, 2.0}) {
        const Flow flow = gubser(q, 1);
        const std::vector<double> times =
            q == 1 ? std::vector<double>{1.2, 1.5, 2} : std::vector<double>{1.2, 1.5};
        const auto shots = run_plane(flow, {.n = n, .times = times}, plane_methods().recommended());
        for (std::size_t k = 0; k < shots.size(); ++k) {
            const Snapshot& shot = shots[k];
            table.row({report::number(q, 1), report::number(shot.time, 2),
                       report::fixed(100 * shot.l1_eps, 3), report::fixed(100 * shot.l1_u, 3),
                       std::to_string(shot.counters.steps), report::timing(shot.seconds)});
            run.record("q=" + report::number(q, 1) + " tau=" + report::number(shot.time, 2), n,
                       {{"l1_eps", shot.l1_eps}, {"l1_u", shot.l1_u}, {"cpu_seconds", shot.seconds, "s"}});
            if (q != 1) {
                other = std::max(other, shot.l1_eps);
                continue;
            }
            const FlowProfile exact = flow.exact(shot.time);
            plot::draw_exact(eps, 0, 4, [&](double r) { return std::pow(exact(r).temperature, 4); },
                             {.label = k == 0 ? "exact" : "", .colour = plot::black, .width = 1, .layer = 2});
            plot::Values r, value, r_error, relative;
            const std::size_t stride = n / 250;
            for (std::size_t i = 0; i < shot.r.size(); ++i) {
                if (i % stride == 0 && shot.r[i] < 4) r.push_back(shot.r[i]), value.push_back(shot.eps[i]);
                const double by = 100 * (shot.eps[i] / shot.exact_eps[i] - 1);
                if (i % 4 == 0 && shot.r[i] < 2.5 && std::abs(by) < 2)
                    r_error.push_back(shot.r[i]), relative.push_back(by);
            }
            const plot::Style look{.label = "τ = " + report::number(shot.time, 2),
                                   .colour = plot::cycle(k),
                                   .marker = plot::Marker::circle};
            eps.points(r, value, plot::dots(look, 4));
            error.points(r_error, relative, plot::dots(look, 2));
            if (shot.time < 1.6)
                worst_eps = std::max(worst_eps, shot.l1_eps), worst_u = std::max(worst_u, shot.l1_u),
                seconds = shot.seconds;
        }
    }
    run.save(figure);
    run.fill("gubser", table.markdown());
    run.fill("gubser-seconds", report::timing(seconds));
    run.claim("gubser-good", [&] { return worst_eps < 3e-3 && worst_u < 1e-3; });
    run.claim("gubser-other", [&] { return other < 8e-3 && other > 3e-3; });
    run.claim("gubser-cheap", [&] { return seconds < 20.8 / 4; });
}

}  // namespace sph::transverse
