#include <cmath>

#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {
namespace {

/// How far the last tenth of the particles is from the exact temperature: mean of |ln T/T_exact|.
double edge_error(const Snapshot& shot) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < shot.r.size(); ++i) {
        if (shot.exact_temperature[i] < 1e-3 || shot.exact_temperature[i] > 0.15) continue;
        sum += std::abs(std::log(shot.temperature[i] / shot.exact_temperature[i])), count += 1;
    }
    return sum / std::max(count, 1.0);
}

}  // namespace

/// The edge at tau = 15, and a start at tau0 = R/100.
void hard_cases(report::Run& run) {
    const std::size_t n = run.quick() ? 600 : 5000;
    plot::Figure figure{"hard-cases", 1, 2};
    plot::Panel& edge =
        figure.at(0, 0).labels("$r$", "$T$/$T$_{0}").log_y().x_range(16, 24).y_range(0.02, 0.3);
    plot::Panel& early = figure.at(0, 1).labels("$r$", "$T$/$T$_{0}").x_range(0, 18).y_range(0, 0.3);
    const Flow late = cylinder(10, 1, 1.0 / 3), young = cylinder(10, 0.1, 1.0 / 3);
    std::map<std::string, double> at_edge, at_start;
    for (const char* name : {"fixed-h", "spiral-graded"}) {
        const PlaneMethod& method = plane_methods()[name];
        const Snapshot shot = run_plane(late, {.n = n, .times = {15}}, method).back();
        const Snapshot small = run_plane(young, {.n = n, .times = {5}}, method).back();
        at_edge[name] = edge_error(shot), at_start[name] = small.l1_temperature;
        const std::size_t stride = n / 500;
        const auto dots = [&](plot::Panel& panel, const Snapshot& from) {
            plot::Values r, T;
            for (std::size_t i = 0; i < from.r.size(); i += std::max<std::size_t>(stride, 1)) {
                r.push_back(from.r[i]), T.push_back(from.temperature[i]);
            }
            panel.points(r, T, plot::dots(method.styled(), 3));
        };
        dots(edge, shot), dots(early, small);
        run.record(std::string{name} + " edge", n, {{"mean_log_temperature", at_edge[name]}});
        run.record(std::string{name} + " tau0=0.1", n, {{"l1_temperature", at_start[name]}});
    }
    const FlowProfile exact = late.exact(15), exact_young = young.exact(5);
    plot::draw_exact(edge, 16, 23.999, [&](double r) { return std::max(exact(r).temperature, 1e-3); });
    plot::draw_exact(early, 0, 14.899, [&](double r) { return exact_young(r).temperature; });
    early.legend.shown = false;
    run.save(figure);
    run.fill("edge-fixed", report::number(at_edge["fixed-h"], 2));
    run.fill("edge-best", report::number(at_edge["spiral-graded"], 2));
    run.fill("early-fixed", report::percent(at_start["fixed-h"]));
    run.fill("early-best", report::percent(at_start["spiral-graded"]));
    run.claim("edge-needs-h", [&] { return at_edge["fixed-h"] > 3 * at_edge["spiral-graded"]; });
    run.claim("early-start", [&] { return at_start["spiral-graded"] < 0.5 * at_start["fixed-h"]; });
}

}  // namespace sph::transverse
