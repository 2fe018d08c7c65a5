#include <cmath>
#include <map>

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

/// The edge at tau = 15, and a start at tau0 = R/1000.
void hard_cases(report::Run& run) {
    const std::size_t n = run.quick() ? 600 : 5000;
    plot::Figure figure{"hard-cases", 1, 2};
    plot::Panel& edge =
        figure.at(0, 0).labels("$r$", "$T$/$T$_{0}").log_y().x_range(16, 24).y_range(0.02, 0.3);
    const Flow late = cylinder(10, 1, 1.0 / 3);
    std::map<std::string, double> at_edge;
    for (const char* name : {"fixed-h", "spiral-graded"}) {
        const PlaneMethod& method = plane_methods()[name];
        const Snapshot shot = run_plane(late, {.n = n, .times = {15}}, method).back();
        at_edge[name] = edge_error(shot);
        plot::Values r, T;
        for (std::size_t i = 0; i < shot.r.size(); i += std::max<std::size_t>(n / 1000, 1)) {
            if (shot.r[i] > 16) r.push_back(shot.r[i]), T.push_back(shot.temperature[i]);
        }
        edge.points(r, T, plot::dots(method.styled(), 3));
        run.record(std::string{name} + " edge", n, {{"mean_log_temperature", at_edge[name]}});
    }
    const FlowProfile exact = late.exact(15);
    plot::draw_exact(edge, 16, 23.999, [&](double r) { return std::max(exact(r).temperature, 1e-3); });
    std::map<bool, double> at_start;
    constexpr double tau0 = 0.01, end = 3;
    const Flow young = cylinder(10, tau0, 1.0 / 3);
    plot::Panel& early = figure.at(0, 1).labels("$r$", "$T$/$T$_{0}").x_range(0, 14);
    for (const bool careful : {false, true}) {
        const Snapshot shot =
            run_plane(young, {.n = n, .times = {end}, .careful = careful}, plane_methods().recommended())
                .back();
        at_start[careful] = shot.l1_temperature;
        plot::Values r, T;
        for (std::size_t i = 0; i < shot.r.size(); i += std::max<std::size_t>(n / 500, 1))
            r.push_back(shot.r[i]), T.push_back(shot.temperature[i]);
        early.points(r, T,
                     plot::dots({.label = careful ? "steps that know τ" : "steps from sound alone",
                                 .colour = plot::cycle(careful ? 0 : 1),
                                 .marker = careful ? plot::Marker::circle : plot::Marker::square},
                                3));
        run.record(
            careful ? "careful tau0=0.01" : "careless tau0=0.01", n,
            {{"l1_temperature", shot.l1_temperature}, {"steps", static_cast<double>(shot.counters.steps)}});
    }
    const FlowProfile exact_young = young.exact(end);
    plot::draw_exact(early, 0, (10 + end - tau0) * 0.9999,
                     [&](double r) { return exact_young(r).temperature; });
    run.save(figure);
    run.fill("edge-fixed", report::number(at_edge["fixed-h"], 2));
    run.fill("edge-best", report::number(at_edge["spiral-graded"], 2));
    run.fill("early-careless", report::percent(at_start[false]));
    run.fill("early-careful", report::percent(at_start[true]));
    run.claim("edge-needs-h", [&] { return at_edge["fixed-h"] > 3 * at_edge["spiral-graded"]; });
    run.claim("early-start", [&] { return at_start[true] < 0.01 && at_start[false] < 1.1 * at_start[true]; });
}

}  // namespace sph::transverse
