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
    std::string name, tick;
    Switches on;
    std::function<void(Gas<3>&)> listed;  // the pass with its effects listed
};

template <class... E>
std::function<void(Gas<3>&)> pass_of(E... effect) {
    return [=](Gas<3>& gas) { gas.sum(sph::Effects{effect...}); };
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{
        {"density", "ρ", {.density = true}, pass_of(sph::SummedDensity{})},
        {"continuity", "dρ/d$t$", {.continuity = true}, pass_of(Continuity{})},
        {"pressure", "$p$", {.pressure = true}, pass_of(PressureForce{})},
        {"heating", "d$u$/d$t$", {.heating = true}, pass_of(PressureHeating{})},
        {"viscosity", "Π", {.viscosity = true}, pass_of(ArtificialViscosity{})},
        {"pressure + viscosity",
         "$p$ + Π",
         {.pressure = true, .viscosity = true},
         pass_of(PressureForce{}, ArtificialViscosity{})},
        {"all", "all", {true, true, true, true, true}, [](Gas<3>& gas) { gas.sum(all_forces()); }}};
    return all;
}

struct Form {
    std::string name, label;
};
const std::vector<Form>& forms() {
    static const std::vector<Form> all{{"listed", "**listed at compile time**"},
                                       {"if a tile", "tiles, an if for each tile"},
                                       {"virtual a tile", "tiles, a virtual call for each tile"},
                                       {"listed a pair", "listed, one pair at a time"},
                                       {"if a pair", "an if for each pair"},
                                       {"virtual a pair", "a virtual call for each pair"}};
    return all;
}

/// Nanoseconds a pair of each form, for one scene.
std::vector<double> measure(report::Run& run, Gas<3>& gas, const Scene& scene) {
    SwitchedTiles tiles{scene.on};
    VirtualTiles virtual_tiles{scene.on};
    OnePairAtATime single{gas, scene.on};
    const std::vector<Lap> laps =
        race(run, {{"listed", [&] { scene.listed(gas); }},
                   {"if a tile", [&] { gas.sum(sph::Effects{tiles}); }},
                   {"virtual a tile", [&] { gas.sum(sph::Effects{virtual_tiles}); }},
                   {"listed a pair", [&] { single.listed(); }},
                   {"if a pair", [&] { single.with_ifs(); }},
                   {"virtual a pair", [&] { single.with_virtual_calls(); }}});
    std::vector<double> ns;
    for (const Lap& lap : laps) ns.push_back(1e9 * lap.median / static_cast<double>(gas.neighbours.pairs()));
    return ns;
}

}  // namespace

void effects(report::Run& run) {
    Gas<3> gas{run.quick() ? std::size_t{14} : 46, 1.185};
    gas.find();
    std::vector<std::string> header{"form"};
    std::vector<std::vector<double>> ns(forms().size());
    plot::Figure figure{"effects"};
    figure.panel_width = 480;
    plot::Panel& panel = figure.panel().titled("3D, 58 neighbours, one core");
    panel.labels("effects of the scene", "CPU time a pair [ns]");
    for (const Scene& scene : scenes()) {
        header.push_back(scene.name);
        const std::vector<double> measured = measure(run, gas, scene);
        for (std::size_t f = 0; f < forms().size(); ++f) {
            ns[f].push_back(measured[f]);
            run.result(forms()[f].name + ": " + scene.name, static_cast<long>(gas.particles.size()),
                       "ns_per_pair", measured[f], "ns");
        }
        panel.x.ticks.push_back(static_cast<double>(panel.x.ticks.size()));
        panel.x.tick_names.push_back(scene.tick);
    }
    header.emplace_back("listed = 1");
    report::Table table{header};
    const auto last = static_cast<double>(scenes().size() - 1);
    for (std::size_t f = 0; f < forms().size(); ++f) {
        std::vector<std::string> row{forms()[f].label};
        double least = 1e300, most = 0;
        for (std::size_t s = 0; s < scenes().size(); ++s) {
            row.push_back(report::timing(ns[f][s]));
            least = std::min(least, ns[f][s] / ns[0][s]);
            most = std::max(most, ns[f][s] / ns[0][s]);
        }
        row.push_back(f == 0 ? "1" : report::timing(least) + " to " + report::timing(most));
        table.row(row);
        panel.curve(panel.x.ticks, ns[f],
                    {.label = forms()[f].name,
                     .colour = plot::cycle(f % 3),
                     .dash = f < 3 ? plot::Dash::solid : plot::Dash::dashed,
                     .width = 0.8,
                     .marker = f < 3 ? plot::Marker::circle : plot::Marker::square});
    }
    panel.legend.outside = true;
    panel.x_range(-0.3, last + 0.3).y_range(0, 1.1 * ns.back().back());
    run.save(figure);
    run.fill("bench-effects", table.markdown());
    run.fill("bench-absent", report::timing(ns[0].back() / ns[0][2]));
}

}  // namespace bench
