#include "chapters/04_artificial_viscosity/scenes/one_at_a_time.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chapters/04_artificial_viscosity/figures/sod_entropy.hpp"
#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/standing_wave.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"

/// The recommended method taken apart, on even particles and on disordered ones.
namespace sph::shocks {
namespace {

using report::Quantities;

constexpr double jitter = 0.3;

Quantities errors_of(const TubeScene& scene, const Method<1>& method) {
    const TubeRun tube = run_tube(scene, method);
    return tube.errors() + Quantities{{"velocity_noise", between_contact_and_shock(tube, scene).noise}};
}

/// The mean of each quantity over three disorders of the start: one is chance.
Quantities disordered_tube(TubeScene scene, const Method<1>& method) {
    scene.jitter = jitter;
    Quantities mean;
    constexpr unsigned long seeds = 3;
    for (scene.seed = 1; scene.seed <= seeds; ++scene.seed) {
        const Quantities one = errors_of(scene, method);
        if (mean.empty()) mean = Quantities(one.size());
        for (std::size_t k = 0; k < one.size(); ++k) {
            mean[k].name = "rough_" + one[k].name;
            mean[k].unit = one[k].unit;
            mean[k].value += one[k].value / seeds;
        }
    }
    return mean;
}

Quantities measured(const report::Run& run, const Combination& one) {
    TubeScene tube;
    tube.n = run.quick() ? 90 : 360;
    tube.threads = run.threads();
    Quantities all = errors_of(tube, one.line) + disordered_tube(tube, one.line);
    const StandingWave wave{.n = run.quick() ? 16u : 64u, .threads = run.threads()};
    all = all + Quantities{{"wave_l1_v", run_standing_wave(wave, one.line).error}};
    if (!one.plane) return all;
    NohScene noh;
    noh.n = run.quick() ? 12 : 30;
    noh.threads = run.threads();
    return all + Quantities{{"noh_l1_rho", run_noh(noh, *one.plane).l1_rho}};
}

report::Comparison table_of() {
    using namespace report;
    return {{"viscosity", "kernel", "conduction"},
            {{"wave, v %", "wave_l1_v", in_percent()},
             {"Sod, ρ %", "l1_rho", in_percent()},
             {"v %", "l1_v", in_percent()},
             {"noise of v %", "velocity_noise", in_percent()},
             {"spike of P %", "wiggle_p", in_percent()},
             {"disordered: ρ %", "rough_l1_rho", in_percent()},
             {"v %", "rough_l1_v", in_percent()},
             {"noise of v %", "rough_velocity_noise", in_percent()},
             {"spike of P %", "rough_wiggle_p", in_percent()},
             {"Noh in the plane, ρ %", "noh_l1_rho", in_percent(), "–"}}};
}

/// The colour says the viscosity, a filled marker the narrow kernel, a square conduction.
plot::Style look_of(const Combination& one, bool labelled) {
    plot::Style look = plot::dots(plot::look_of(one.look, labelled ? one.viscosity : ""), 8);
    look.marker = one.parts.conducts ? plot::Marker::square : plot::Marker::circle;
    look.filled = !one.parts.wide;
    return look;
}

void draw(report::Run& run, const std::vector<std::pair<Combination, Quantities>>& all) {
    plot::Figure figure{"one-at-a-time", 1, 2};
    plot::Panel& v = figure.at(0, 0).log_log().titled("velocity");
    v.labels("error of $v$, even particles", "error of $v$, disordered");
    plot::Panel& rho = figure.at(0, 1).log_log().titled("density");
    rho.labels("error of ρ, even particles", "error of ρ, disordered");
    for (const auto& [panel, quantity] : {std::pair{&v, "l1_v"}, {&rho, "l1_rho"}}) {
        std::vector<std::string> labelled;
        for (const auto& [one, values] : all) {
            const bool first = std::find(labelled.begin(), labelled.end(), one.viscosity) == labelled.end();
            labelled.push_back(one.viscosity);
            panel->points({report::value_of(values, quantity)},
                          {report::value_of(values, std::string{"rough_"} + quantity)}, look_of(one, first));
        }
    }
    v.curve({0.01, 0.06}, {0.01, 0.06}, {.colour = plot::black, .width = 1, .layer = 0});
    rho.curve({0.005, 0.012}, {0.005, 0.012}, {.colour = plot::black, .width = 1, .layer = 0});
    rho.legend.shown = false;
    run.save(figure);
}

/// What the text says of the combinations: `of` finds a quantity of one of them.
template <class Of>
void assert_text(report::Run& run, const Of& of) {
    const double alone = of("signal 0.5 wide", "l1_v");
    run.claim("apart-even", [&] {
        const auto two_fifths = [](double part) { return part > 0.5 && part < 0.7; };
        return two_fifths(of("slopes wide", "l1_v") / alone) &&
               two_fifths(of("signal 0.5 narrow", "l1_v") / alone) &&
               of("slopes narrow", "l1_v") < 0.45 * alone;
    });
    run.claim("contact-speed", [&] {
        bool holds = true;
        for (const char* name : {"signal 0.5 wide", "slopes wide"}) {
            const std::string conducting = std::string{name} + " conducting";
            const double spike = of(conducting, "wiggle_p") / of(name, "wiggle_p"),
                         error = of(conducting, "l1_rho") / of(name, "l1_rho");
            holds = holds && spike > 0.28 && spike < 0.38 && error > 1.09 && error < 1.17;
        }
        return holds;
    });
    run.claim("apart-switch", [&] {
        return of("morris-monaghan narrow", "l1_v") < 1.3 * of("slopes narrow", "l1_v") &&
               of("morris-monaghan narrow", "wave_l1_v") > 3 * of("slopes narrow", "wave_l1_v") &&
               of("morris-monaghan narrow", "rough_l1_v") > 1.1 * of("slopes narrow", "rough_l1_v");
    });
    run.claim("apart-conduction", [&] {
        const auto gains = [&](const std::string& name, const std::string& quantity) {
            return of(name, quantity) / of(name + " conducting", quantity);
        };
        bool holds = true;
        for (const char* name : {"signal 0.5 wide", "signal 0.5 narrow", "slopes wide", "slopes narrow"})
            holds = holds && gains(name, "wiggle_p") > 2.9 && gains(name, "rough_wiggle_p") > 2 &&
                    gains(name, "l1_rho") < 1 && gains(name, "rough_l1_rho") > 1;
        return holds;
    });
    run.claim("apart-disordered", [&] {
        return of("slopes narrow conducting", "rough_l1_v") >
                   of("signal 0.5 wide conducting", "rough_l1_v") &&
               of("slopes wide", "rough_velocity_noise") >
                   2 * of("signal 0.5 wide", "rough_velocity_noise") &&
               of("slopes narrow", "rough_velocity_noise") >
                   2 * of("signal 0.5 narrow", "rough_velocity_noise");
    });
    run.claim("apart-large-k", [&] {
        return of("signal 0.85 narrow", "l1_v") > 1.5 * of("signal 0.5 narrow", "l1_v") &&
               of("signal 0.85 narrow", "rough_velocity_noise") <
                   0.7 * of("signal 0.5 narrow", "rough_velocity_noise");
    });
    run.claim("apart-plane", [&] {
        return of("slopes wide", "noh_l1_rho") < of("signal 0.5 wide", "noh_l1_rho") &&
               of("slopes narrow", "noh_l1_rho") < of("signal 0.5 narrow", "noh_l1_rho") &&
               of("slopes wide", "noh_l1_rho") < of("slopes narrow", "noh_l1_rho");
    });
}

}  // namespace

void one_at_a_time(report::Run& run) {
    report::Comparison table = table_of();
    std::vector<std::pair<Combination, Quantities>> all;
    for (const Combination& one : combinations()) {
        const Quantities values = measured(run, one);
        table.add(run, one.name, run.quick() ? 90 : 360,
                  {one.viscosity, one.parts.wide ? "wide" : "narrow", one.parts.conducts ? "(4.9)" : "none"},
                  values);
        all.emplace_back(one, values);
    }
    run.fill("one-at-a-time", table.markdown());
    assert_text(run, [&](const std::string& name, const std::string& quantity) {
        for (const auto& [one, values] : all) {
            if (one.name == name) return report::value_of(values, quantity);
        }
        throw std::out_of_range{"no such combination: " + name};
    });
    draw(run, all);
}

}  // namespace sph::shocks
