#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/exact/shear_wave.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

/// Of the pairs in a shear half approach each other, so that (8.7) gives alpha/8 c_s h for a viscosity that
/// acts on all, and half of it for one that acts on approaching pairs only.
constexpr double all_pairs = 1.0 / 8, half_the_pairs = 1.0 / 16;

void draw_map(plot::Panel& map, const ShearRun& shear) {
    map.equal_aspect = true;
    map.particles({.name = "velocity",
                   .x = shear.x[0],
                   .y = shear.x[1],
                   .value = shear.v_x,
                   .diameter = 4.5,
                   .bar = {.label = "$v$_{x}", .map = plot::Map::blue_red, .range = std::array{-0.1, 0.1}}});
}

void draw_theory(plot::Panel& decay, const ShearRun& shear) {
    plot::Values by_theory;
    const exact::ShearWave wave{half_the_pairs * shear.h, 1, 1, 1};
    for (const double at : shear.t) by_theory.push_back(wave.velocity(0.25, at));
    decay.curve(shear.t, by_theory,
                {.label = "ν = α $c$_{s} $h$ / 16", .colour = plot::black, .dash = plot::Dash::dotted});
}

}  // namespace

void shear_layer(report::Run& run) {
    ShearScene scene;
    scene.n = run.quick() ? 16 : 32;
    if (run.quick()) scene.time = 1;
    plot::Figure figure{"shear-layer", 1, 2};
    plot::Panel& decay = figure.at(0, 0).labels("$t$ $c$_{s} / $L$", "amplitude of the shear");
    plot::Panel& map = figure.at(0, 1).titled("α = 1, β = 2, at the end").labels("$x$", "$y$");
    using namespace report;
    Comparison table{{"method"},
                     {{"ν / (c_s h)", "viscosity", decimals(3)},
                      {"at first", "first_viscosity", decimals(3)},
                      {"noise v_y / V", "noise", digits(1)},
                      {"CPU [s]", "cpu_seconds", time_in(1)}}};
    std::map<std::string, double> nu, nu_at_first;  // in c_s h
    std::string together = "no viscosity, Balsara, Colagrossi";
    for (const Method<2>& method : plane_methods().without({"signal-cubic"})) {
        const ShearRun shear = run_shear(scene, method);
        table.add(run, method.name, scene.n, {method.label}, shear.measured());
        nu[method.name] = shear.viscosity / shear.h,
        nu_at_first[method.name] = shear.first_viscosity / shear.h;
        const bool one_of_three =
            method.name == "none" || method.name == "balsara" || method.name == "colagrossi";
        decay.curve(shear.t, shear.amplitude,
                    one_of_three ? plot::rest(std::exchange(together, "")) : plot::line(method.styled()));
        if (method.name != "alpha-beta") continue;
        draw_map(map, shear);
        draw_theory(decay, shear);
    }
    table.add(run, "grid", scene.n, {"grid, with dx for h"}, run_shear_grid(scene).measured());
    table.add_words({"(8.7), all pairs", fixed(all_pairs, 3)});
    table.add_words({"(8.7), approaching pairs only", fixed(half_the_pairs, 3)});
    decay.y_range(0.6, 1.05);
    run.save(figure);
    run.fill("shear-layer", table.markdown());
    run.claim(
        "shear-is-viscous",
        [&] { return nu["alpha-beta"] > 0.75 * half_the_pairs && nu["alpha-beta"] < half_the_pairs; },
        report::Needs::any_run);
    run.claim("shear-cured", [&] {
        return std::all_of(nu.begin(), nu.end(), [&](const auto& of) {
            return of.first == "alpha-beta" || of.first.starts_with("signal") || of.first == "none-cubic" ||
                   std::abs(of.second) < 0.05 * nu["alpha-beta"];
        });
    });
    run.claim("lattice-viscosity", [&] {
        return nu_at_first["none-cubic"] > 0.8 * nu_at_first["alpha-beta"] &&
               std::abs(nu_at_first["none"]) < 0.2 * nu_at_first["alpha-beta"];
    });
}

}  // namespace sph::shocks
