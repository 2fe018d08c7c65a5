#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"

/// What each member takes for one evaluation of the rates, its rows found anew: nanoseconds for each
/// particle.
namespace sph::fpm {

void cost_of_estimates(report::Run& run) {
    constexpr std::size_t n = 400;
    report::Table table{{"listed", "sums of densities", "unknowns", "ns per particle"}};
    std::vector<std::string> names;
    plot::Values ns;
    const auto add = [&](const std::string& name, const std::string& label, const std::string& densities,
                         const std::string& unknowns, const BurgersScene& scene) {
        const double time = 1e9 * run.time(rates_of(scene)).best / static_cast<double>(n);
        run.record(name, n, {{"cpu_ns_per_particle", time, "ns"}});
        table.row({label, densities, unknowns, report::timing(time)});
        names.push_back(label), ns.push_back(time);
    };
    BurgersScene scene;
    scene.n = n;
    for (const char* name : {"sph", "brookshaw", "cspm", "fpm", "sfpm", "taylor", "mls"}) {
        const LineMethod& method = moving_methods()[name];
        const bool plain = std::string_view{name} == "sph" || std::string_view{name} == "brookshaw";
        add(name, method.label, std::string_view{name} == "mls" ? "no" : "yes", plain ? "none" : "3",
            method.on(scene));
    }
    scene.moving = Moving::with_u, scene.estimate = "mls", scene.order = 4;
    add("mls-4", "MLS, order 4", "no", "5", scene);
    scene.moving = Moving::still, scene.estimate = "fdm", scene.order = 4;
    add("fdm-4", "rows that stand still", "no", "none", scene);
    run.fill("cost-of-estimates", table.markdown());
    run.claim("rows-are-the-price",
              [&] { return run.checking() || (ns[4] > 5 * ns.back() && ns[3] < 2.5 * ns[0]); });
    plot::Figure figure{"cost-of-estimates"};
    figure.panel().bars(names, ns).labels("ns per particle and evaluation", "");
    run.save(figure);
}

}  // namespace sph::fpm
