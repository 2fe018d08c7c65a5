#include <memory>

#include "tests/bench/benches.hpp"
#include "tests/bench/gas.hpp"
#include "tests/bench/race.hpp"
#include "tests/bench/switched.hpp"

/// What effects cost: listed at compile time, switched on and off at run time, called virtually; from the
/// same particles and the same list, 3D, one thread.
namespace bench {
namespace {

struct Scene {
    std::string name;
    Switches on;
};

struct Form {
    std::string name, label;
};

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{{"pressure", {.pressure = true}},
                                        {"pressure + viscosity", {.pressure = true, .viscosity = true}},
                                        {"all", {true, true, true, true, true}}};
    return all;
}

/// The pass of one scene with its effects listed.
std::function<void()> listed(Gas<3>& gas, std::size_t scene) {
    if (scene == 0) return [&] { gas.sum(sph::Effects{PressureForce{}}); };
    if (scene == 1) return [&] { gas.sum(sph::Effects{PressureForce{}, ArtificialViscosity{}}); };
    return [&] { gas.sum(all_forces()); };
}

}  // namespace

void effects(report::Run& run) {
    Gas<3> gas{run.quick() ? std::size_t{14} : 46, 1.185};
    gas.find();
    const double pairs = static_cast<double>(gas.neighbours.pairs());
    const std::vector<Form> forms{{"listed", "**listed at compile time**"},
                                  {"if a tile", "tiles, an if for each tile"},
                                  {"virtual a tile", "tiles, a virtual call for each tile"},
                                  {"listed a pair", "listed, one pair at a time"},
                                  {"if a pair", "an if for each pair"},
                                  {"virtual a pair", "a virtual call for each pair"}};
    report::Table table{{"form", "pressure [ns a pair]", "pressure + viscosity", "all five", "listed = 1"}};
    std::vector<std::vector<std::string>> rows;
    for (const Form& form : forms) rows.push_back({form.label});
    plot::Figure figure{"effects"};
    plot::Panel& panel = figure.panel().titled("3D, 58 neighbours, one core");
    panel.labels("effects of the scene", "CPU time a pair [ns]");
    std::vector<plot::Values> curves(forms.size());
    std::vector<std::vector<double>> ns(forms.size());
    for (std::size_t s = 0; s < scenes().size(); ++s) {
        const Switches on = scenes()[s].on;
        SwitchedTiles tiles{on};
        VirtualTiles virtual_tiles{on};
        OnePairAtATime single{gas, on};
        const std::vector<Runner> ways{{"listed", listed(gas, s)},
                                       {"if a tile", [&] { gas.sum(sph::Effects{tiles}); }},
                                       {"virtual a tile", [&] { gas.sum(sph::Effects{virtual_tiles}); }},
                                       {"listed a pair", [&] { single.listed(); }},
                                       {"if a pair", [&] { single.with_ifs(); }},
                                       {"virtual a pair", [&] { single.with_virtual_calls(); }}};
        const std::vector<Lap> laps = race(ways, run.quick() ? 2 : 7);
        for (std::size_t f = 0; f < forms.size(); ++f) {
            ns[f].push_back(1e9 * laps[f].median / pairs);
            rows[f].push_back(report::timing(ns[f].back()));
            run.result(forms[f].name + ": " + scenes()[s].name, static_cast<long>(gas.particles.size()),
                       "ns_per_pair", ns[f].back(), "ns");
        }
    }
    for (std::size_t f = 0; f < forms.size(); ++f) {
        rows[f].push_back(report::timing(ns[f][0] / ns[0][0]) + ", " + report::timing(ns[f][1] / ns[0][1]) +
                          ", " + report::timing(ns[f][2] / ns[0][2]));
        table.row(rows[f]);
        panel.curve({1, 2, 3}, ns[f],
                    {.label = forms[f].name,
                     .colour = plot::cycle(f % 3),
                     .dash = f < 3 ? plot::Dash::solid : plot::Dash::dashed,
                     .marker = f < 3 ? plot::Marker::circle : plot::Marker::square});
    }
    panel.x.ticks = {1, 2, 3};
    panel.x.tick_names = {"pressure", "+ viscosity", "all five"};
    panel.legend.outside = true;
    panel.x_range(0.8, 3.2).y_range(0, 1.1 * ns[5][2]);
    run.save(figure);
    run.fill("bench-effects", table.markdown());
    run.fill("bench-absent", report::timing(ns[0][2] / ns[0][0]));
}

}  // namespace bench
