#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/tube_report.hpp"
#include "chapters/08_landau_model/figures/figures.hpp"
#include "common/app/error.hpp"
#include "common/exact/landau.hpp"

/// The scenes of the reader's own: `run 08 --scene slab` and `--scene tube` with the chapter's options.
namespace sph::landau {
namespace {

/// The methods of the slab as chapter 4 lists methods.
std::vector<Method> listed_slab_methods() {
    std::vector<Method> list;
    for (const SlabMethod& method : slab_methods())
        list.push_back({method.name, method.label, method.kernel, method.h});
    return list;
}

void draw(report::Run& run, const SlabProfile& profile) {
    const exact::LandauSlab solution{profile.time};
    constexpr int points = 1001;
    plot::Values x, s_star, eps, rapidity;
    for (int k = 0; k < points; ++k) {
        x.push_back(solution.edge() * (2.0 * k / (points - 1) - 1) * (1 - 1e-9));
        const auto at = solution.at(x.back());
        s_star.push_back(at.s_star), eps.push_back(at.eps), rapidity.push_back(at.rapidity);
    }
    plot::Figure figure{"slab-scene", 2, 2};
    const auto panel = [&](int row, int column, const std::string& label, const Column& value,
                           const plot::Values& exact) -> plot::Panel& {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label);
        axes.curve(x, exact, exact_line());
        axes.points(profile.x, value, {.label = "SPH", .marker = plot::Marker::circle, .marker_size = 3});
        return axes;
    };
    panel(0, 0, "$s$*", profile.s_star, s_star);
    panel(0, 1, "rapidity", profile.rapidity, rapidity);
    panel(1, 0, "$s$*", profile.s_star, s_star).log_y();
    panel(1, 1, "ε", profile.eps, eps).log_y();
    run.save(figure);
}

}  // namespace

void Options::declare(app::CommandLine& line) {
    const app::Range scale{-1e12, 1e12};
    line.numbers("left", left, scale, "", "tube: rest density, velocity and pressure at x < 0; 0,v,0: vacuum",
                 3)
        .numbers("right", right, scale, "", "tube: the same at x > 0", 3)
        .number("gamma", gamma, {1, 2, true}, "", "tube: adiabatic index")
        .number("time", time, {0, 1e3}, "time",
                "how long the scene runs; 0: 10 for the slab, 0.4 for the tube")
        .integer("particles", particles, 10, 1000000,
                 "slab: in |x| <= 1; tube: of equal baryon number in |x| < 0.5")
        .number("jitter", jitter, {0, 0.49}, "spacings", "tube: largest random shift of each particle")
        .number("courant", courant, {0, 1}, "",
                "step over the shortest crossing time; 0: 0.08 for the slab, 0.45 for the tube")
        .text("method", method, "NAME", "'list' names the scene's; default: the recommended one");
}

void slab_scene(report::Run& run, const Options& options) {
    if (options.method == "list") return run.print(method_list(listed_slab_methods()));
    const SlabMethod& method = slab_method(choose_method(options.method, listed_slab_methods()).name);
    SlabScene scene;
    scene.n = static_cast<std::size_t>(options.particles);
    scene.times = {options.time > 0 ? options.time : 10};
    if (scene.times[0] > exact::LandauSlab::largest_time)
        throw app::UsageError{"--time: " + std::to_string(options.time) + " is not allowed; allowed: 0.." +
                              std::to_string(exact::LandauSlab::largest_time)};
    if (options.courant > 0) scene.courant = options.courant;
    scene.threads = run.threads();
    const SlabProfile profile = run_slab(scene, method).back();
    const auto row = [&](const std::string& quantity, double value) {
        run.result(method.name, options.particles, quantity, value);
    };
    row("l1_s_star", profile.l1_s_star);
    row("energy_drift", profile.energy_drift);
    row("momentum_drift", profile.momentum);
    row("edge_gap", profile.edge_gap);
    row("steps", static_cast<double>(profile.counters.steps));
    row("pairs", static_cast<double>(profile.counters.pairs));
    run.result(method.name, options.particles, "cpu_seconds", profile.seconds, "s");
    std::string csv = "x,s_star,exact_s_star,eps,exact_eps,rapidity,exact_rapidity,v,exact_v\n";
    for (std::size_t i = 0; i < profile.x.size(); ++i)
        csv += report::csv_row({profile.x[i], profile.s_star[i], profile.exact_s_star[i], profile.eps[i],
                                profile.exact_eps[i], profile.rapidity[i], profile.exact_rapidity[i],
                                std::tanh(profile.rapidity[i]), std::tanh(profile.exact_rapidity[i])});
    run.write("profile.csv", csv);
    draw(run, profile);
}

void tube_scene(report::Run& run, const Options& options) {
    if (options.method == "list") return run.print(method_list(relativistic_methods()));
    const Method& method = choose_method(options.method, relativistic_methods());
    TubeScene scene{tube_state("left", options.left), tube_state("right", options.right), options.gamma,
                    options.time > 0 ? options.time : 0.4};
    if (scene.left.rho == 0 && scene.right.rho == 0)
        throw app::UsageError{"--left: vacuum on both sides is not allowed; allowed: on one"};
    scene.n = static_cast<std::size_t>(options.particles);
    scene.jitter = options.jitter;
    scene.seed = run.seed();
    if (options.courant > 0) scene.courant = options.courant;
    scene.threads = run.threads();
    const RelativisticTubeRun tube = [&] {
        try {
            return run_relativistic_tube(scene, method);
        } catch (const std::invalid_argument& error) {
            throw app::UsageError{std::string{"--left, --right, --time: "} + error.what()};
        }
    }();
    if (tube.profile.x.empty()) throw app::UsageError{"--time: the gas has left |x| < 0.5; allowed: less"};
    run.result(method.name, options.particles, "shock_position", tube.shock);
    run.result(method.name, options.particles, "shock_error", tube.shock_error);
    report_tube(run, method.name, options.particles, tube,
                exact_profile(exact_tube(relativistic_solution(scene), scene.time)));
}

std::string below(double value) {
    const double power = std::ceil(std::log10(std::max(std::abs(value), 1e-15)));
    return "< 1e" + std::to_string(static_cast<int>(power));
}

TubeScene problem(int which) {
    if (which == 1) return {{10, 0, 13.33}, {1, 0, 1e-8}, 5.0 / 3, 0.4};
    return {{1, 0, 1000}, {1, 0, 0.01}, 5.0 / 3, 0.35};
}
TubeScene streams(double lorentz, double p, double gamma) {
    const double v = std::sqrt(1 - 1 / (lorentz * lorentz));
    return {{1, v, p}, {1, -v, p}, gamma, 0.3};
}

}  // namespace sph::landau
