#include "chapters/08_landau_model/figures/slab_profiles.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/exact/landau.hpp"
#include "common/plot/looks.hpp"

namespace sph::landau {
namespace {

struct Line {
    plot::Values x, s_star, eps, rapidity;
};
/// The exact solution in 0 <= x < 1 + t, dense towards the edge.
Line exact_line_of(double t) {
    constexpr int points = 201;
    const exact::LandauSlab solution{t};
    Line line;
    for (int k = 0; k < points; ++k) {
        const double gap = std::pow(1 - static_cast<double>(k) / (points - 1), 3);
        const double x = solution.edge() * (1 - std::max(gap, 1e-9));
        const auto at = solution.at(x);
        line.x.push_back(x), line.s_star.push_back(at.s_star);
        line.eps.push_back(at.eps), line.rapidity.push_back(at.rapidity);
    }
    return line;
}

struct Panels {
    plot::Panel &s_star, &rapidity, &eps, &error;
};

void draw(const Panels& panels, const SlabProfile& profile, std::size_t k) {
    const std::size_t n = profile.x.size();
    const Line exact = exact_line_of(profile.time);
    const auto both = [&](plot::Panel& panel, const plot::Values& line, const Column& value) {
        draw_right_half(panel, profile, value, k);
        panel.curve(exact.x, line, plot::exact(k == 0 ? "exact" : ""));
    };
    both(panels.s_star, exact.s_star, profile.s_star);
    both(panels.rapidity, exact.rapidity, profile.rapidity);
    both(panels.eps, exact.eps, profile.eps);
    plot::Values place, relative;
    for (std::size_t i = n / 2; i < n; ++i) {
        place.push_back(profile.x[i] / (1 + profile.time));
        relative.push_back(100 * (profile.s_star[i] / profile.exact_s_star[i] - 1));
    }
    panels.error.curve(place, relative, {.colour = plot::cycle(k), .width = 1});
}

}  // namespace

std::string at_time(double t) {
    return fmt::format("$t$ = {:g}", t);
}

void draw_right_half(plot::Panel& panel, const SlabProfile& profile, const Column& value, std::size_t k) {
    const std::size_t n = profile.x.size(), stride = std::max<std::size_t>(n / 80, 1);
    plot::Values x, y;
    for (std::size_t i = n / 2; i < n; i += stride) x.push_back(profile.x[i]), y.push_back(value[i]);
    const plot::Style look{
        .label = at_time(profile.time), .colour = plot::cycle(k), .marker = plot::Marker::circle};
    panel.points(x, y, plot::dots(look));
}

std::vector<SlabProfile> slab_profiles(report::Run& run, const std::string& name,
                                       const std::vector<double>& times) {
    const SlabMethod& method = slab_methods().recommended();
    const SlabScene scene{
        .n = run.quick() ? 200UL : 1000UL, .times = times, .courant = SlabScene::fast_courant};
    plot::Figure figure{name, 2, 2};
    const Panels panels{figure.at(0, 0).labels("$x$", "$s$*"),
                        figure.at(0, 1).labels("$x$", "rapidity $y$").y_range(0, 6),
                        figure.at(1, 0).labels("$x$", "ε").log_y().y_range(1e-6, 2),
                        figure.at(1, 1).labels("$x$/(1 + $t$)", "error of $s$* [%]").y_range(-2, 2)};
    panels.rapidity.legend.shown = panels.eps.legend.shown = panels.error.legend.shown = false;
    report::Table table{
        {"t", "relative L1 of s*", "energy drift", "momentum", "last particle to edge", "steps"}};
    std::size_t k = 0;
    std::vector<SlabProfile> profiles = run_slab(scene, method);
    for (const SlabProfile& profile : profiles) {
        draw(panels, profile, k++);
        run.record(method.name + " t=" + report::number(profile.time, 3), scene.n,
                   {{"l1_s_star", profile.l1_s_star},
                    {"energy_drift", profile.energy_drift},
                    {"momentum_drift", profile.momentum}});
        table.row({report::number(profile.time, 3), report::number(profile.l1_s_star, 2),
                   report::below(profile.energy_drift),
                   report::below(std::max(std::abs(profile.momentum), 1e-13)),
                   report::number(profile.edge_gap, 2), std::to_string(profile.counters.steps)});
    }
    run.save(figure);
    run.fill(name, table.markdown());
    return profiles;
}

}  // namespace sph::landau
