#include "chapters/05_tensile_instability/figures/cures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/text.hpp"

namespace sph::tensile {

CureScene cure_scene(const report::Run& run) {
    CureScene scene;
    if (run.quick()) scene.n = 12, scene.time = 30;
    return scene;
}
std::vector<std::uint64_t> cure_seeds(const report::Run& run) {
    if (run.quick()) return {1};
    return {1, 2, 3};
}

Merits merits_of(const CureMethod& method, const CureScene& scene, const std::vector<std::uint64_t>& seeds) {
    const report::Quantities lattice = lattice_merits(method, scene.pressure);
    Merits merits{report::value_of(lattice, "growth"), report::value_of(lattice, "sound_speed"),
                  report::value_of(lattice, "shear_speed"), {}};
    for (const std::uint64_t seed : seeds) {
        CureScene seeded = scene;
        seeded.seed = seed;
        CureRun one = run_cure(seeded, method);
        if (seed == seeds.front()) {
            merits.run = std::move(one);
            continue;
        }
        CureRun& worst = merits.run;
        worst.smallest_distance = std::min(worst.smallest_distance, one.smallest_distance);
        worst.order = std::min(worst.order, one.order);
        worst.momentum_drift = std::max(worst.momentum_drift, one.momentum_drift);
        worst.energy_drift = std::max(worst.energy_drift, one.energy_drift);
        worst.seconds = std::min(worst.seconds, one.seconds);
    }
    return merits;
}

report::Quantities Merits::measured() const {
    return report::Quantities{{"growth", growth, "c/dx"},
                              {"sound_speed", sound_speed, "c"},
                              {"shear_speed", shear_speed, "c"}} +
           run.measured();
}

bool Merits::holds() const {
    return growth < 1e-3 && std::abs(sound_speed - 1) < 0.03 && run.momentum_drift < 1e-14 &&
           run.order > 0.95 && run.smallest_distance > 0.9;
}

namespace {

/// Growth and error of the speed of sound, a name at each point.
void draw_growth(plot::Panel& panel, const CureMethod& method, const Merits& merits, bool left) {
    const double x = 100 * std::abs(merits.sound_speed - 1), y = std::max(0.0, merits.growth);
    plot::Style look{.marker = merits.holds() ? plot::Marker::circle : plot::Marker::cross};
    look.colour = plot::cycle(merits.holds() ? 0 : 1), look.marker_size = 6;
    panel.points({x}, {y}, look);
    plot::Note& note = panel.note(x + (left ? -0.1 : 0.1), y, method.label);
    note.anchor = left ? plot::Anchor::right : plot::Anchor::left;
    note.size = 7;
}

void draw_order(plot::Panel& panel, const CureMethod& method, const Merits& merits, bool named) {
    const double x = std::max(1e-18, merits.run.momentum_drift), y = merits.run.smallest_distance;
    plot::Style look{.marker = merits.holds() ? plot::Marker::circle : plot::Marker::cross};
    look.colour = plot::cycle(merits.holds() ? 0 : 1), look.marker_size = 6;
    panel.points({x}, {y}, look);
    if (!named) return;
    plot::Note& note = panel.note(1.8 * x, y, method.label);
    note.size = 7;
}

/// The family between exact momentum and order: the share w of P_j - P_i.
void draw_family(report::Run& run, plot::Panel& growth, plot::Panel& order, const CureScene& scene) {
    plot::Values error, grows, drift, distance;
    for (const double w : {0.0, 0.5, 0.9, 0.98, 1.0}) {
        CureMethod method = cure_methods()["difference"];
        method.parameters.set("weight", w);
        const Merits merits = merits_of(method, scene, {1});
        run.record(fmt::format("difference-{:g}", w), scene.n, merits.measured());
        error.push_back(100 * std::abs(merits.sound_speed - 1)), grows.push_back(std::max(0.0, merits.growth));
        drift.push_back(std::max(1e-18, merits.run.momentum_drift));
        distance.push_back(merits.run.smallest_distance);
    }
    growth.curve(error, grows, plot::rest("share w of P_j - P_i, 0 to 1"));
    order.curve(drift, distance, plot::rest(""));
}

/// The rows of the text's table: one of each kind.
const std::vector<std::string> shown{"none",     "viscosity", "stress-xsph", "shifting",
                                     "corrected", "linear-exact", "background", "balanced"};

}  // namespace

void cures(report::Run& run) {
    const CureScene scene = cure_scene(run);
    plot::Figure figure{"cures", 1, 2};
    figure.panel_width = 430, figure.panel_height = 340;
    plot::Panel& growth = figure.at(0, 0).labels("error of the speed of sound [%]", "growth [$c$/dx]");
    plot::Panel& order =
        figure.at(0, 1).labels("momentum drift a particle [$c$]", "smallest distance [dx]").log_x();
    using namespace report;
    Comparison table{{"cure"},
                     {{"growth [c/dx]", "growth", or_word(1e-3, "< 0.001", decimals(2))},
                      {"sound [c]", "sound_speed", decimals(3)},
                      {"order", "order", decimals(2)},
                      {"momentum drift", "momentum_drift", or_word(1e-14, "rounding", digits(1))},
                      {"energy drift", "energy_drift", digits(1)}}};
    std::map<std::string, Merits> all;
    const std::vector<std::string> left{"xsph", "linear-exact", "wendland"},
        beside{"none", "corrected", "reference", "difference", "background", "stress-xsph"};
    const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const CureMethod& method : cure_methods()) {
        const Merits merits = merits_of(method, scene, cure_seeds(run));
        run.record(method.name, scene.n, merits.measured());
        if (is_in(shown, method.name)) table.show({method.label}, merits.measured(), Digits::noisy);
        draw_growth(growth, method, merits, is_in(left, method.name));
        draw_order(order, method, merits, is_in(beside, method.name));
        all[method.name] = merits;
    }
    draw_family(run, growth, order, scene);
    growth.x_range(0, 9).y_range(-0.03, 0.8);
    order.x_range(1e-18, 1).y_range(0, 1.05);
    run.save(figure);
    run.fill("cures", table.markdown());
    run.claim("cures-two-hold", [&] {
        return std::all_of(all.begin(), all.end(), [](const auto& one) {
            return one.second.holds() == (one.first == "background" || one.first == "balanced");
        });
    });
    run.claim("cures-slow-only", [&] {
        return std::all_of(all.begin(), all.end(), [](const auto& one) {
            const bool slow = one.second.growth > 0.1;
            return slow || one.first == "corrected" || one.first == "reference" ||
                   one.first == "background" || one.first == "balanced";
        });
    });
    run.claim("cures-limited", [&] {
        return std::abs(all["limited"].growth - all["linear-exact"].growth) < 0.05 &&
               all["transport"].growth < 0.6 * all["limited"].growth;
    });
}

}  // namespace sph::tensile
