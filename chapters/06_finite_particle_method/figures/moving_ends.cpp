#include <limits>
#include <map>

#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/exact/burgers.hpp"
#include "common/plot/looks.hpp"

/// Particles that move with u, with the three kinds of ends of (Ye et al. 2019, figures 2-4).
namespace sph::fpm {
namespace {

/// What became of a run.
struct Fate {
    double crossed = -1;  ///< first crossing, -1: none
    double error = 0;     ///< largest at t = 1, infinite for a run that was stopped
    bool stopped = false;
    std::string text() const {
        if (stopped) return crossed < 0 ? "stopped" : report::fixed(crossed, 2);
        return crossed >= 0 ? report::fixed(crossed, 2) : "none (" + report::number(error, 1) + ")";
    }
};

Fate fate_of(report::Run& run, const BurgersScene& scene, const std::string& name) {
    const BurgersRun line = try_burgers(scene);
    if (line.first_crossing >= 0)
        run.record(name, scene.n, {{"first_crossing", line.first_crossing, "time"}});
    if (line.stopped >= 0) {
        run.record(name, scene.n, {{"stopped", line.stopped, "time"}});
        return {line.first_crossing, std::numeric_limits<double>::infinity(), true};
    }
    if (line.first_crossing < 0) run.record(name, scene.n, {{"linf_u", line.errors.back().linf}});
    return {line.first_crossing, line.errors.back().linf, false};
}

void draw(plot::Figure& figure) {
    constexpr double viscosity = 0.02, t = 0.6;
    const exact::Burgers exact{viscosity};
    int column = 0;
    for (const char* ends : {"frozen", "free", "mirror"}) {
        plot::Panel& panel = figure.at(0, column);
        panel.titled(ends).labels("$x$", "$u$ at $t$ = 0.6").x_range(0, 1.1).y_range(-0.5, 1.6);
        panel.legend.shown = column++ == 0;
        plot::draw_exact(panel, 0, 1, [&](double x) { return exact.velocity(x, t); });
        for (const char* name : {"sph", "cspm", "sfpm", "taylor"}) {
            const LineMethod& method = moving_methods()[name];
            BurgersScene scene = method.on({});
            scene.viscosity = viscosity, scene.time = t, scene.ends = ends_named(ends);
            const BurgersRun line = try_burgers(scene);
            panel.points(line.x, line.u, plot::dots(method.styled(), 4));
        }
    }
}

/// gamma = 1, where hardly anything moves: all methods, until u has fallen to a hundredth. What is listed
/// beside SFPM has mirrors only.
void gentle(report::Run& run) {
    report::Table table{{"method", "frozen", "free", "mirror"}};
    bool members_hold = true, repulsion_is_wrong = false, free_fails = true;
    double best = 1;
    for (const LineMethod& method : moving_methods()) {
        if (method.name == "mls") continue;
        std::vector<std::string> row{method.label};
        for (const char* ends : {"frozen", "free", "mirror"}) {
            BurgersScene scene = method.on({});
            scene.n = run.quick() ? 20 : 40, scene.viscosity = 1, scene.time = 0.5;
            scene.ends = ends_named(ends), scene.stops_at_crossing = true;
            const bool mirrors = scene.ends == Ends::mirror;
            if (method.moving != Moving::with_u && !mirrors) {
                row.push_back("–");
                continue;
            }
            const Fate fate = fate_of(run, scene, method.name + " " + ends + " gamma 1");
            row.push_back(fate.text());
            const bool holds = fate.crossed < 0 && !fate.stopped && fate.error < 0.1;
            if (scene.ends == Ends::free) free_fails = free_fails && !holds;
            if (mirrors && method.name == "repulsion") repulsion_is_wrong = fate.error > 1;
            if (mirrors && method.name != "repulsion") members_hold = members_hold && holds;
            if (mirrors) best = std::min(best, fate.error);
        }
        table.row(row);
    }
    run.fill("gentle", table.markdown());
    run.claim("gentle-holds",
              [&] { return members_hold && repulsion_is_wrong && free_fails && best < 1e-4; });
}

}  // namespace

void moving_ends(report::Run& run) {
    std::map<std::string, Fate> fates;
    report::Table table{
        {"method", "frozen, γ = 0.1", "0.02", "free, γ = 0.1", "0.02", "mirror, γ = 0.1", "0.02", "0.005"}};
    for (const char* name : {"sph", "brookshaw", "cspm", "fpm", "sfpm", "taylor"}) {
        const LineMethod& method = moving_methods()[name];
        std::vector<std::string> row{method.label};
        for (const char* ends : {"frozen", "free", "mirror"}) {
            for (const double viscosity : {0.1, 0.02, 0.005}) {
                if (viscosity == 0.005 && std::string_view{ends} != "mirror") continue;
                BurgersScene scene = method.on({});
                scene.n = run.quick() ? 40 : 100;
                scene.viscosity = viscosity, scene.ends = ends_named(ends);
                scene.stops_at_crossing = true;
                const std::string which = std::string{name} + " " + ends + " gamma " + written(viscosity);
                fates[which] = fate_of(run, scene, which);
                row.push_back(fates[which].text());
            }
        }
        table.row(row);
    }
    run.fill("fates", table.markdown());
    const auto of = [&](const std::string& which) { return fates.at(which); };
    run.claim("ends-of-moving", [&] {
        bool fails = true;
        for (const char* name : {"sph", "brookshaw", "cspm", "fpm", "sfpm", "taylor"}) {
            const Fate free = of(std::string{name} + " free gamma 0.1"),
                       frozen = of(std::string{name} + " frozen gamma 0.02");
            fails = fails && (free.stopped || free.error > 1) && (frozen.stopped || frozen.crossed > 0);
        }
        return fails && of("sfpm mirror gamma 0.1").error < 1e-3 && of("fpm mirror gamma 0.1").error < 1e-3;
    });
    run.claim("mirrors-do-not-cure", [&] {
        const auto early = [&](const std::string& name) {
            const Fate fate = of(name + " mirror gamma 0.005");
            return fate.crossed > 0.3 && fate.crossed < 0.42;
        };
        return early("sph") && early("cspm") && early("fpm") && early("sfpm") && early("taylor") &&
               of("brookshaw mirror gamma 0.005").crossed < 0 &&
               of("brookshaw mirror gamma 0.005").error > 0.2;
    });
    run.claim("own-value-damps", [&] {
        return of("taylor mirror gamma 0.02").crossed < 0 && of("taylor mirror gamma 0.02").error < 0.02 &&
               of("sfpm mirror gamma 0.02").crossed > 0;
    });
    gentle(run);
    plot::Figure figure{"moving-ends", 1, 3};
    draw(figure);
    run.save(figure);
}

}  // namespace sph::fpm
