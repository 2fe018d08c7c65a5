#include "chapters/04_artificial_viscosity/scenes/tube_command.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "common/app/error.hpp"
#include "common/plot/looks.hpp"

namespace sph::shocks {
namespace {

std::vector<double> numbers(const exact::Riemann::State& state) {
    return {state.rho, state.v, state.p};
}

/// Throws app::UsageError for a density or pressure below 0, or where only one of them is 0.
exact::Riemann::State state_of(const std::string& option, const std::vector<double>& values) {
    const exact::Riemann::State state{values[0], values[1], values[2]};
    if (state.rho < 0 || state.p < 0)
        throw app::UsageError{"--" + option +
                              ": density or pressure below 0 is not allowed; allowed: 0 and above"};
    if ((state.rho == 0) != (state.p == 0))
        throw app::UsageError{
            "--" + option +
            ": only one of density and pressure is 0, which is not allowed; allowed: both (a "
            "vacuum) or none"};
    return state;
}

void draw(report::Run& run, const TubeRun& tube, const Profile& line) {
    plot::Figure figure{"tube", 2, 2};
    const auto panel = [&](int row, int column, const std::string& label, Column Profile::*quantity) {
        plot::beside_exact(figure.at(row, column).labels("$x$", label), line.x, line.*quantity,
                           tube.profile.x, tube.profile.*quantity);
    };
    panel(0, 0, "ρ", &Profile::rho);
    panel(0, 1, "$v$", &Profile::v);
    panel(1, 0, "$P$", &Profile::p);
    panel(1, 1, "$u$", &Profile::u);
    run.save(figure);
}

/// What a scene makes of options that cannot be checked one by one.
template <class Make>
auto checked(Make&& make) {
    try {
        return make();
    } catch (const std::invalid_argument& error) {
        throw app::UsageError{std::string{"--left, --right, --time: "} + error.what()};
    }
}

}  // namespace

TubeCommand::TubeCommand() : TubeCommand{{tube_methods(), {}, {1, 10, true}, gas_tube}} {}

TubeCommand::TubeCommand(TubeKind kind)
    : kind_{std::move(kind)},
      method_{kind_.methods, any_kernel_names(), {0.5, 8}},
      left_{numbers(kind_.defaults.left)},
      right_{numbers(kind_.defaults.right)},
      gamma_{kind_.defaults.gamma},
      time_{kind_.defaults.time},
      courant_{kind_.defaults.courant},
      particles_{static_cast<long>(kind_.defaults.n)} {}

void TubeCommand::declare(app::CommandLine& line) {
    const app::Range scale{-1e12, 1e12};
    line.numbers("left", left_, scale, "", "density, velocity and pressure at x < 0; 0,v,0: vacuum", 3)
        .numbers("right", right_, scale, "", "density, velocity and pressure at x > 0", 3)
        .number("gamma", gamma_, kind_.gamma, "", "adiabatic index")
        .number("time", time_, {0, 1e6, true}, "time", "how long the scene runs")
        .integer("particles", particles_, 10, 1000000, "of equal mass in |x| < 0.5 at the start")
        .number("jitter", jitter_, {0, 0.49}, "spacings", "largest random shift of each particle")
        .number("courant", courant_, {0.001, 0.6}, "", "step over the shortest time between neighbours");
    method_.declare(line);
}

TubeScene TubeCommand::scene(const report::Run& run) const {
    TubeScene scene = kind_.defaults;
    scene.left = state_of("left", left_);
    scene.right = state_of("right", right_);
    if (scene.left.rho == 0 && scene.right.rho == 0)
        throw app::UsageError{"--left: vacuum on both sides is not allowed; allowed: on one"};
    scene.gamma = gamma_;
    scene.time = time_;
    scene.n = static_cast<std::size_t>(particles_);
    scene.jitter = jitter_;
    scene.seed = run.seed();
    scene.courant = courant_;
    scene.threads = run.threads();
    return scene;
}

void TubeCommand::run(report::Run& run) const {
    if (method_.wants_list()) return run.print(kind_.methods.text());
    const Method<1> method = method_.chosen();
    TubeScene tube_scene = scene(run);
    tube_scene.progress = run.progress();
    const TubeProblem problem = checked([&] { return kind_.problem(tube_scene); });
    const TubeRun tube = checked([&] { return run_tube(tube_scene, method, problem); });
    if (tube.profile.x.empty()) throw app::UsageError{"--time: the gas has left |x| < 0.5; allowed: less"};
    run.record(method.name, tube_scene.n, tube.errors());
    run.record(method.name, tube_scene.n, tube.drifts());
    run.record(method.name, tube_scene.n, tube.costs());
    run.record(method.name, tube_scene.n, {{"pairs", static_cast<double>(tube.counters.pairs)}});
    if (kind_.more) run.record(method.name, tube_scene.n, kind_.more(tube_scene, tube));
    const auto& [profile, exact] = std::tie(tube.profile, tube.exact);
    run.write("profile.csv", report::csv({{"x", profile.x},
                                          {"rho", profile.rho},
                                          {"v", profile.v},
                                          {"p", profile.p},
                                          {"u", profile.u},
                                          {"exact_rho", exact.rho},
                                          {"exact_v", exact.v},
                                          {"exact_p", exact.p},
                                          {"exact_u", exact.u}}));
    draw(run, tube, exact_profile(problem.exact));
}

}  // namespace sph::shocks
