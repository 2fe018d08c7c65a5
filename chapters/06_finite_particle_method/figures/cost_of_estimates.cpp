#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "chapters/06_finite_particle_method/scenes/turns.hpp"

/// What each member, and each way to move, takes for one evaluation of the rates: nanoseconds and bytes for
/// each particle.
namespace sph::fpm {
namespace {

struct Listed {
    std::string name, label, unknowns;
    BurgersScene scene;
    bool has_densities = true;
};

/// The members with particles that move with u, their rows found anew; then what is listed beside SFPM or
/// MLS; last, rows that are only applied.
std::vector<Listed> all_listed() {
    BurgersScene scene;
    scene.n = 400;
    std::vector<Listed> all;
    const auto add = [&](const std::string& name, const std::string& label, const std::string& unknowns) {
        all.push_back({name, label, unknowns, moving_methods()[name].on(scene)});
    };
    for (const char* name : {"sph", "brookshaw"}) add(name, moving_methods()[name].label, "none");
    for (const char* name : {"cspm", "fpm", "sfpm", "taylor", "mls"})
        add(name, moving_methods()[name].label, "3");
    all.back().has_densities = false;
    add("xsph", "SFPM + XSPH", "3");
    add("shifting", "SFPM + shifting", "3");
    add("repulsion", "SFPM + repulsion", "3");
    BurgersScene fourth = moving_methods()["frame-4"].on(scene);
    fourth.moving = Moving::with_u;
    all.push_back({"mls-4", "MLS, order 4", "5", fourth, false});
    all.push_back({"fdm-4", "rows that stand still", "none", still_methods()["fdm-4"].on(scene), false});
    return all;
}

}  // namespace

void cost_of_estimates(report::Run& run) {
    const std::vector<Listed> all = all_listed();
    std::vector<std::function<void()>> works;
    for (const Listed& one : all) works.push_back(rates_of(one.scene));
    const std::vector<double> seconds = timed_in_turns(run, works);
    report::Table table{
        {"listed", "sums of densities", "unknowns", "bytes of rows per particle", "ns per particle"}};
    std::vector<std::string> names;
    plot::Values ns;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Listed& one = all[k];
        names.push_back(one.label), ns.push_back(1e9 * seconds[k] / static_cast<double>(one.scene.n));
        const double bytes = bytes_of_rows(one.scene);
        run.record(one.name, one.scene.n,
                   {{"cpu_ns_per_particle", ns.back(), "ns"}, {"bytes_per_particle", bytes, "byte"}});
        table.row({one.label, one.has_densities ? "yes" : "no", one.unknowns, report::fixed(bytes, 0),
                   report::timing(ns.back())});
    }
    run.fill("cost-of-estimates", table.markdown());
    const auto of = [&](const char* name) {
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[k].name == name) return ns[k];
        return 0.0;
    };
    run.claim("rows-are-the-price", [&] {
        return run.checking() || (of("sfpm") > 20 * of("fdm-4") && of("fpm") < 2.5 * of("sph"));
    });
    run.claim("beside-sfpm", [&] {
        return run.checking() || (of("xsph") < of("shifting") && of("shifting") > 1.1 * of("sfpm") &&
                                  of("repulsion") > 1.1 * of("sfpm"));
    });
    plot::Figure figure{"cost-of-estimates"};
    figure.panel().bars(names, ns).labels("ns per particle and evaluation", "");
    run.save(figure);
}

}  // namespace sph::fpm
