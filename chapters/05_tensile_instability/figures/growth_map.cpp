#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "common/plot/looks.hpp"

namespace sph::tensile {
namespace {

struct Case {
    std::string name, title;
    double h_over_dx, P_x, P_y;
};

GrowingWave<2> draw(plot::Panel& panel, const Case& one, int points) {
    const auto lattice = named_lattice<2>("cubic", one.h_over_dx);
    Tensor<2> pressure = isotropic<2>(one.P_x);
    pressure[1][1] = one.P_y;
    plot::Values k, rate;
    for (int n = 0; n <= points; ++n) k.push_back(double(n) / points);
    for (const double k_y : k)
        for (const double k_x : k) rate.push_back(growth<2>(lattice, pressure, {pi * k_x, pi * k_y}));
    panel.titled(one.title).labels("$k_{x}$ d$x$ / π", "$k_{y}$ d$x$ / π");
    panel.equal_aspect = true;
    panel.field({.name = one.name, .x = k, .y = k, .value = rate, .bar = {.label = "growth / ($c$/d$x$)"}});
    const auto fastest = fastest_wave<2>(lattice, pressure);
    panel.points({std::abs(fastest.k[0]) / pi}, {std::abs(fastest.k[1]) / pi},
                 {.colour = plot::Colour{1, 1, 1}, .marker = plot::Marker::cross, .marker_size = 8});
    return fastest;
}

}  // namespace

void growth_map(report::Run& run) {
    const std::vector<Case> cases{{"tension", "tension, $P$ = −0.2, $h$ = 1.2 d$x$", 1.2, -0.2, -0.2},
                                  {"axial", "tension along $y$ alone, 0.2, $h$ = 1.2 d$x$", 1.2, 0, -0.2},
                                  {"pressure", "pressure, $P$ = 0.2, $h$ = 1.5 d$x$", 1.5, 0.2, 0.2}};
    plot::Figure figure{"growth-map", 1, 3};
    std::vector<GrowingWave<2>> fastest;
    for (std::size_t n = 0; n < cases.size(); ++n) {
        fastest.push_back(draw(figure.at(0, static_cast<int>(n)), cases[n], run.quick() ? 20 : 60));
        run.record(cases[n].name, 1,
                   {{"growth", fastest.back().rate, "c/dx"},
                    {"k_x", fastest.back().k[0], "1/dx"},
                    {"k_y", fastest.back().k[1], "1/dx"}});
    }
    run.save(figure);
    run.fill("map-tension", report::fixed(fastest[0].rate, 3));
    run.fill("map-axial", report::fixed(fastest[1].rate, 3));
    run.fill("map-pressure", report::fixed(fastest[2].rate, 3));
    run.claim(
        "map-tension", [&] { return fastest[0].k[0] > 0.999 * pi && std::abs(fastest[0].k[1]) < 1e-3; },
        report::Needs::any_run);
    run.claim(
        "map-axial",
        [&] { return std::abs(fastest[1].k[1]) > 0.999 * pi && fastest[1].rate > 0.9 * fastest[0].rate; },
        report::Needs::any_run);
    run.claim(
        "map-pressure",
        [&] { return std::abs(fastest[2].k[0] - fastest[2].k[1]) < 1e-3 && fastest[2].rate > 0.1; },
        report::Needs::any_run);
}

}  // namespace sph::tensile
