#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chapters/05_tensile_instability/figures/cures.hpp"
#include "chapters/05_tensile_instability/scenes/response.hpp"
#include "common/plot/looks.hpp"
#include "common/report/text.hpp"

namespace sph::tensile {
namespace {

constexpr std::array tensions{0.1, 0.2, 0.5};

CureMethod with_background(double over_tension) {
    CureMethod method = cure_methods()["balanced"];
    method.parameters.set("background", over_tension), method.parameters.set("alpha", 0);
    return method;
}

/// The least background pressure over the tension with a growth below 1e-3.
double least_background(double tension) {
    double low = 0, high = 3;
    while (high - low > 1e-3) {
        const double middle = 0.5 * (low + high);
        (Response{with_background(middle), -tension}.growth() < 1e-3 ? high : low) = middle;
    }
    return high;
}

/// Kernels and smoothing lengths, and the growth that a balanced background leaves under tension beside that
/// of the plain scheme under the pressure P + P_b, which the narrow kernel then carries.
double most_unlike(report::Run& run) {
    constexpr double tension = 0.2;
    double most = 0;
    for (const auto& [kernel, h] : {std::pair{"cubic", 1.2},
                                    {"cubic", 1.5},
                                    {"quintic", 1.0},
                                    {"wendland-c2", 1.5},
                                    {"wendland-c4", 1.6}}) {
        CureMethod held = with_background(1.5), plain = cure_methods()["none"];
        held.kernel = plain.kernel = kernel, held.h_over_dx = plain.h_over_dx = h;
        const double left = std::max(0.0, Response{held, -tension}.growth());
        const double pressed = std::max(0.0, Response{plain, 0.5 * tension}.growth());
        run.record(fmt::format("{}-{:g}", kernel, h), Response::per_side,
                   {{"growth", left, "c/dx"},
                    {"growth_without", Response{plain, -tension}.growth(), "c/dx"},
                    {"growth_under_pressure", pressed, "c/dx"}});
        most = std::max(most, std::abs(left - pressed));
    }
    return most;
}

/// What a wide kernel leaves that is not wide enough: the largest growth below the method's own width, and
/// from it on.
std::array<double, 2> growth_by_width(report::Run& run) {
    std::array<double, 2> most{};
    const double chosen = cure_methods()["balanced"].parameters.value("width");
    for (const double width : {1.25, 1.5, 1.75, chosen, 2.0, 2.25, 2.5}) {
        CureMethod method = with_background(1.5);
        method.parameters.set("width", width);
        const double growth = Response{method, -0.2}.growth();
        run.record(fmt::format("width-{:g}", width), Response::per_side, {{"growth", growth, "c/dx"}});
        double& side = most[width < chosen ? 0 : 1];
        side = std::max(side, growth);
    }
    return most;
}

/// Growth with the chosen cure where the cubic spline is narrower and wider, smallest h first.
std::vector<double> growth_by_h(report::Run& run) {
    std::vector<double> grows;
    for (const double h : {1.1, 1.2, 1.3, 1.5}) {
        CureMethod method = with_background(1.5);
        method.h_over_dx = h;
        grows.push_back(Response{method, -0.2}.growth());
        run.record(fmt::format("h-{:g}", h), Response::per_side, {{"growth", grows.back(), "c/dx"}});
    }
    return grows;
}

/// The free drop: how its radius ends, by whatever holds its particles in order. Much viscosity, so that it
/// comes to rest.
CureRun run_drop(const CureScene& of, CureMethod method, double h) {
    CureScene scene = of;
    scene.drop = true, scene.jitter = 0;
    method.parameters.set("alpha", 1);
    method.h_over_dx = h;
    return run_cure(scene, method);
}

double kept_shear(const CureScene& of, const CureMethod& method) {
    CureScene scene = of;
    scene.shear = 0.05;
    return run_cure(scene, method).kept_shear;
}

}  // namespace

/// How strong the balanced background must be, by the matrix of the lattice; and whether what it makes is
/// still a fluid with a free surface.
void balanced_strength(report::Run& run) {
    plot::Figure figure{"balanced-strength", 1, 2};
    plot::Panel& growth = figure.at(0, 0).labels("$P$_{b} / tension", "growth [$c$/dx]");
    plot::Panel& sound = figure.at(0, 1).labels("$P$_{b} / tension", "speed of sound [$c$]");
    for (std::size_t which = 0; which < tensions.size(); ++which) {
        plot::Values strength, grows, speed;
        const int points = run.quick() ? 6 : 16;
        for (int k = 0; k <= points; ++k) {
            strength.push_back(2.0 * k / points);
            const Response response{with_background(strength.back()), -tensions[which]};
            grows.push_back(response.growth()), speed.push_back(response.sound_speed());
        }
        const std::string label = fmt::format("tension {:g} ρ $c$^{{2}}", tensions[which]);
        growth.curve(strength, grows, {.label = label, .colour = plot::cycle(which)});
        sound.curve(strength, speed, {.label = label, .colour = plot::cycle(which)});
    }
    run.save(figure);
    std::array<double, 3> least{};
    for (std::size_t which = 0; which < tensions.size(); ++which) {
        least[which] = least_background(tensions[which]);
        run.record(fmt::format("tension-{:g}", tensions[which]), Response::per_side,
                   {{"least_background", least[which], "tension"}});
    }
    CureScene scene = cure_scene(run);
    std::map<std::string, double> radius, distance, shear;
    for (const char* name : {"viscosity", "background", "balanced"}) {
        // The drop's spacing shrinks to 0.91: from h = 1 dx to 1.1, which no particles pair at.
        const CureRun drop = run_drop(scene, cure_methods()[name], 1.0);
        radius[name] = drop.radius, distance[name] = drop.smallest_distance;
        run.record(std::string{"drop-"} + name, scene.n,
                   {{"radius", drop.radius, "start"}, {"smallest_distance", drop.smallest_distance, "dx"}});
    }
    for (const char* name : {"background", "balanced"}) {
        shear[name] = kept_shear(scene, cure_methods()[name]);
        run.record(std::string{"shear-"} + name, scene.n, {{"kept_shear", shear[name]}});
    }
    CureMethod frictionless = cure_methods()["balanced"];
    frictionless.parameters.set("alpha", 0);
    const CureRun warm = run_cure(scene, frictionless);
    run.record("balanced-frictionless", scene.n, warm.measured());
    run.fill("frictionless-distance", report::fixed(warm.smallest_distance, 1));
    run.claim("frictionless-holds", [&] { return warm.smallest_distance > 0.5 && warm.energy_drift < 1e-6; });
    const std::array<double, 2> by_width = growth_by_width(run);
    run.fill("narrow-growth", report::fixed(by_width[0], 2));
    run.claim("wide-enough", [&] { return by_width[0] > 0.02 && by_width[1] < 1e-3; });
    const double unlike = most_unlike(run);
    run.fill("kernels-unlike", report::fixed(unlike, 3));
    run.claim("balanced-is-pressed", [&] { return unlike < 0.02; });
    run.fill("least-background", report::fixed(least[1], 2));
    run.fill("drop-background", report::fixed(radius["background"], 2));
    run.fill("drop-balanced", report::fixed(radius["balanced"], 2));
    run.fill("shear-balanced", report::fixed(shear["balanced"], 2));
    run.claim("shear-flows", [&] {
        const double nu = 0.1 * 1.2 / 8, k = 2 * pi / static_cast<double>(scene.n);
        return std::abs(shear["balanced"] - std::exp(-nu * k * k * scene.time)) < 0.05;
    });
    run.claim("least-of-all-tensions", [&] {
        return std::all_of(least.begin(), least.end(), [](double one) { return one > 0.99 && one < 1.02; });
    });
    const double rest = 1 / std::sqrt(1 - scene.pressure);  // where the density has raised P to 0
    run.claim("drop-grows", [&] {                           // in order: a drop that clumps spreads, too
        return radius["background"] > 1 && radius["background"] > rest + 0.05 && distance["background"] > 0.6;
    });
    run.fill("drop-distance", report::fixed(distance["viscosity"], 1));
    run.fill("drop-distance-balanced", report::fixed(distance["balanced"], 1));
    const CureRun wide = run_drop(scene, cure_methods()["balanced"], 1.2);
    run.record("drop-balanced-wide", scene.n, {{"smallest_distance", wide.smallest_distance, "dx"}});
    run.claim("drop-pairs", [&] { return wide.smallest_distance < 0.3; });
    run.claim("drop-clumps", [&] { return distance["viscosity"] < 0.4 && distance["balanced"] > 0.6; });
    const std::vector<double> by_h = growth_by_h(run);
    run.fill("growth-at-1.5", report::fixed(by_h.back(), 2));
    run.claim("window", [&] { return by_h[1] < 1e-3 && by_h.back() > 0.1; });
    run.claim("shear-is-felt", [&] {
        const double speed = Response{with_background(1.5), -0.2}.shear_speed();
        return speed > 0.04 && speed < 0.08;
    });
    run.claim("drop-balanced", [&] { return std::abs(radius["balanced"] - rest) < 0.03; });
}

}  // namespace sph::tensile
