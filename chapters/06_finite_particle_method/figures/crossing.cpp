#include <map>

#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/plot/looks.hpp"

/// Particles from both sides meet at x = 1 (Ye et al. 2019, figure 5).
namespace sph::fpm {
namespace {

struct Case {
    std::string name;
    std::size_t n;
    long steps;  ///< of the paper: dt = 0.02, 0.01
    double perturbation;
};
const std::array cases{Case{"(i)", 125, 50, 0}, Case{"(ii)", 250, 100, 0}, Case{"(iii)", 250, 100, 0.3}};

BurgersScene scene_of(const Case& which, double h_over_dx, const std::string& estimate, long finer) {
    BurgersScene scene;
    scene.n = which.n, scene.length = 2, scene.viscosity = 0.02;
    scene.moving = Moving::with_u, scene.estimate = estimate, scene.h_over_dx = h_over_dx;
    scene.perturbation = which.perturbation, scene.steps = which.steps * finer;
    return scene;
}

/// First crossing, -1 for none, NaN for a run that was stopped.
double crossing_of(const BurgersScene& scene) {
    BurgersScene one = scene;
    one.stops_at_crossing = true;
    const BurgersRun line = try_burgers(one);
    return line.first_crossing < 0 && line.stopped >= 0 ? std::nan("") : line.first_crossing;
}
std::string text_of(double crossing) {
    return std::isnan(crossing) ? "stopped" : crossing < 0 ? "none" : report::fixed(crossing, 2);
}

void draw(plot::Panel& panel, const BurgersScene& given) {
    BurgersScene scene = given;
    scene.keeps_paths = true;
    const BurgersRun line = try_burgers(scene);
    panel.labels("$t$", "$x$").x_range(0, 0.8).y_range(0.85, 1.15);
    for (std::size_t i = scene.n / 4; i < 3 * scene.n / 4; i += 4) {
        plot::Values x;
        for (const Column& at : line.path_x) x.push_back(at[i]);
        panel.curve(line.path_t, x, {.colour = plot::cycle(i < scene.n / 2 ? 0 : 1), .width = 1});
    }
}

}  // namespace

void crossing(report::Run& run) {
    struct Way {
        std::string label, estimate;
        double h_over_dx;
    };
    const std::array ways{Way{"SPH, h = 12.5 dx", "sph", 12.5}, Way{"SPH, h = 1.25 dx", "sph", 1.25},
                          Way{"Brookshaw, h = 1.25 dx", "brookshaw", 1.25}};
    report::Table table{{"method", "case", "first crossing, paper's dt", "dt/4", "dt/16"}};
    std::map<std::string, std::vector<double>> found;
    for (const Way& way : ways) {
        for (const Case& which : cases) {
            if (way.h_over_dx > 2 && run.quick()) continue;
            if (way.estimate == "sph" && way.h_over_dx < 2 && which.n == 125) continue;
            std::vector<std::string> row{way.label, which.name};
            for (const long finer : {1L, 4L, 16L}) {
                if (finer == 16 && (run.quick() || way.h_over_dx > 2)) continue;
                const double at = crossing_of(scene_of(which, way.h_over_dx, way.estimate, finer));
                found[way.label + which.name].push_back(at);
                row.push_back(text_of(at));
                if (at >= 0)
                    run.record(way.estimate + " h/dx " + report::number(way.h_over_dx, 3) + " " + which.name +
                                   " dt/" + std::to_string(finer),
                               which.n, {{"first_crossing", at, "time"}});
            }
            row.resize(5, "–");
            table.row(row);
        }
    }
    run.fill("crossing", table.markdown());
    run.claim("crossing-is-not-dt", [&] {
        const auto converged = [&](const std::string& which, double tolerance) {
            const auto& at = found.at(which);
            return at[0] > 0 && std::abs(at.back() - at[at.size() - 2]) < tolerance;
        };
        return converged("SPH, h = 12.5 dx(i)", 0.02) && converged("SPH, h = 12.5 dx(ii)", 0.01) &&
               converged("SPH, h = 1.25 dx(ii)", 0.01);
    });
    run.claim("brookshaw-stops", [&] {
        return found.at("Brookshaw, h = 1.25 dx(ii)")[2] < 0 &&
               found.at("Brookshaw, h = 1.25 dx(iii)")[2] < 0;
    });
    run.claim("no-remeshing", [&] {
        return found.at("SPH, h = 12.5 dx(iii)")[1] < found.at("SPH, h = 12.5 dx(ii)")[1] - 0.1 &&
               found.at("SPH, h = 1.25 dx(iii)")[2] < found.at("SPH, h = 1.25 dx(ii)")[2] - 0.1;
    });
    plot::Figure figure{"crossing", 1, 3};
    for (int k = 0; k < 3; ++k) {
        const Way& way = ways[static_cast<std::size_t>(k)];
        draw(figure.at(0, k).titled(way.label),
             scene_of(cases[run.quick() ? 0 : 1], way.h_over_dx, way.estimate, 4));
    }
    run.save(figure);
}

}  // namespace sph::fpm
