#include "chapters/04_artificial_viscosity/figures/plane_style.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "common/exact/shear_wave.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

/// Of the pairs in a shear half approach each other, so that (8.7) gives alpha/8 c_s h for a viscosity that
/// acts on all, and half of it for one that acts on approaching pairs only.
constexpr double all_pairs = 1.0 / 8, half_the_pairs = 1.0 / 16;

}  // namespace

void shear_layer(report::Run& run) {
    ShearScene scene;
    scene.n = run.quick() ? 16 : 32;
    if (run.quick()) scene.time = 1;
    plot::Figure figure{"shear-layer", 1, 2};
    plot::Panel& decay = figure.at(0, 0).labels("$t$ $c$_{s} / $L$", "amplitude of the shear");
    plot::Panel& map = figure.at(0, 1).titled("α = 1, β = 2, at the end").labels("$x$", "$y$");
    report::Table table{{"method", "ν / (c_s h)", "at first", "noise v_y / V", "CPU [s]"}};
    const auto add = [&](const std::string& name, const std::string& label, const ShearRun& shear) {
        run.result(name, static_cast<long>(scene.n), "viscosity", shear.viscosity / shear.h, "c_s h");
        run.result(name, static_cast<long>(scene.n), "first_viscosity", shear.first_viscosity / shear.h,
                   "c_s h");
        run.result(name, static_cast<long>(scene.n), "noise", shear.noise, "V");
        run.result(name, static_cast<long>(scene.n), "momentum_drift", shear.momentum_drift);
        run.result(name, static_cast<long>(scene.n), "energy_drift", shear.energy_drift);
        run.result(name, static_cast<long>(scene.n), "cpu_seconds", shear.seconds, "s");
        table.row({label, report::fixed(shear.viscosity / shear.h, 3),
                   report::fixed(shear.first_viscosity / shear.h, 3), report::number(shear.noise, 1),
                   report::timing(shear.seconds)});
    };
    for (const std::string name :
         {"none-cubic", "none", "alpha-beta", "signal", "balsara", "colagrossi", "reconstructed"}) {
        const ShearRun shear = run_shear(scene, plane_method(name));
        add(name, plane_method(name).label, shear);
        plot::Style style = plane_style(name);
        style.marker = plot::Marker::none;
        decay.curve(shear.t, shear.amplitude, style);
        if (name != "alpha-beta") continue;
        map.equal_aspect = true;
        map.particles(
            {.name = "velocity",
             .x = shear.x[0],
             .y = shear.x[1],
             .value = shear.v_x,
             .diameter = 4.5,
             .bar = {.label = "$v$_{x}", .map = plot::Map::blue_red, .range = std::array{-0.1, 0.1}}});
        plot::Values t, by_theory;
        const exact::ShearWave wave{half_the_pairs * shear.h, 1, 1, 1};
        for (const double at : shear.t) {
            t.push_back(at);
            by_theory.push_back(wave.velocity(0.25, at));
        }
        decay.curve(
            t, by_theory,
            {.label = "ν = α $c$_{s} $h$ / 16", .colour = plot::Colour{0, 0, 0}, .dash = plot::Dash::dotted});
    }
    ShearRun grid = run_shear_grid(scene);
    grid.h = 1 / static_cast<double>(scene.n);
    add("grid", "grid, with dx for h", grid);
    table.row({"(8.7), all pairs", report::fixed(all_pairs, 3), "", "", ""});
    table.row({"(8.7), approaching pairs only", report::fixed(half_the_pairs, 3), "", "", ""});
    decay.y_range(0.3, 1.05);
    run.save(figure);
    run.fill("shear-layer", table.markdown());
}

}  // namespace sph::shocks
