#include "chapters/04_artificial_viscosity/scenes/tube_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "common/app/error.hpp"
#include "common/app/option_text.hpp"
#include "common/plot/looks.hpp"

namespace sph::shocks {
namespace {

std::vector<double> numbers(const exact::Riemann::State& state) {
    return {state.rho, state.v, state.p};
}

/// Throws app::UsageError for a density or pressure below 0, or for pressure without gas.
exact::Riemann::State state_of(const std::string& option, const std::vector<double>& values) {
    const exact::Riemann::State state{values[0], values[1], values[2]};
    if (state.rho < 0 || state.p < 0)
        throw app::UsageError{"--" + option +
                              ": density or pressure below 0 is not allowed; allowed: 0 and above"};
    if (state.rho == 0 && state.p > 0)
        throw app::UsageError{"--" + option +
                              ": pressure without density is not allowed; allowed: both 0 (a vacuum)"};
    return state;
}

/// Sides whose particles, `count` of each, cannot tell what happens there.
void judge_sampling(report::Run& run, const TubeScene& scene, const TubeProblem& problem,
                    const std::array<std::size_t, 2>& count) {
    constexpr std::size_t few = 20;
    for (const std::size_t side : {0U, 1U}) {
        if (problem.density[side] == 0 || count[side] >= few) continue;
        const std::string text = fmt::format("the {} side has {} of {} particles in the window",
                                             side == 0 ? "left" : "right", count[side], scene.n);
        if (count[side] == 0)
            throw app::UsageError{"--particles: " + text + "; allowed: more particles, or --spacing even"};
        run.warn(text + ": its waves are hardly sampled; --spacing even gives it as many as the other");
    }
}

/// Waves that have left the window, a part of it without particles, errors that are no errors any more.
void judge_result(report::Run& run, const TubeScene& scene, const ExactTube& exact, const TubeRun& tube) {
    std::string out;
    for (const Edge& edge : exact.edges) {
        if (!(edge.x > exact.window[0] && edge.x < exact.window[1]))
            out += fmt::format("{}{} (x = {:.4g})", out.empty() ? "" : ", ", edge.name, edge.x);
    }
    if (!out.empty())
        run.warn(fmt::format("at t = {:g} outside the window {:g},{:g}: {}; --window shows them", scene.time,
                             exact.window[0], exact.window[1], out));
    const double widest = (exact.window[1] - exact.window[0]) / 10;
    const Column& x = tube.profile.x;
    for (std::size_t i = 0; i <= x.size(); ++i) {
        const double from = i == 0 ? exact.window[0] : x[i - 1], to = i < x.size() ? x[i] : exact.window[1];
        if (to - from > widest && exact.at(0.5 * (from + to)).rho > 0)
            run.warn(fmt::format("no particle between x = {:.4g} and {:.4g}", from, to));
    }
    constexpr double lost = 0.5;
    for (const report::Quantity& error : tube.errors()) {
        if (error.name.starts_with("l1_") && error.value > lost)
            run.warn(fmt::format("{} is {:.2g}: the run is no solution; more particles may help", error.name,
                                 error.value));
    }
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
      method_{kind_.methods, any_kernel_names(), {0.5, 8}, least_h_over_dx},
      left_{numbers(kind_.defaults.left)},
      right_{numbers(kind_.defaults.right)},
      window_{kind_.defaults.window[0], kind_.defaults.window[1]},
      gamma_{kind_.defaults.gamma},
      time_{kind_.defaults.time},
      courant_{kind_.defaults.courant},
      diaphragm_{kind_.defaults.diaphragm},
      particles_{static_cast<long>(kind_.defaults.n)} {}

void TubeCommand::declare(app::CommandLine& line) {
    const app::Range scale{-1e12, 1e12};
    line.numbers("left", left_, scale, "",
                 "density, velocity and pressure on the left of the diaphragm; 0,v,0: vacuum", 3)
        .numbers("right", right_, scale, "", "the same on the right", 3)
        .numbers("window", window_, scale, "length", "first and last x that is compared and drawn", 2)
        .number("diaphragm", diaphragm_, scale, "length", "where the states meet, inside the window")
        .number("gamma", gamma_, kind_.gamma, "", "adiabatic index")
        .number("time", time_, {0, 1e6, true}, "time", "how long the scene runs")
        .integer("particles", particles_, 10, 1000000, "in the window at the start")
        .choice("spacing", spacing_, {"masses", "even"}, "equal masses, or the same spacing on both sides")
        .number("jitter", jitter_, {0, 0.49}, "spacings", "largest random shift of each particle")
        .number("courant", courant_, {0.001, 0.6}, "", "step over the shortest time between neighbours");
    if (!kind_.velocities.empty()) {
        std::vector<std::string> names;
        for (const auto& [name, make] : kind_.velocities) names.push_back(name);
        line.choice("velocity", velocity_, names, "how the velocities of --left and --right are given");
    }
    method_.declare(line);
}

TubeScene TubeCommand::scene(const report::Run& run) const {
    TubeScene scene = kind_.defaults;
    scene.left = state_of("left", left_);
    scene.right = state_of("right", right_);
    if (!kind_.velocities.empty()) {
        const auto& velocity = kind_.velocities.at(velocity_);
        try {
            scene.left.v = velocity(scene.left.v), scene.right.v = velocity(scene.right.v);
        } catch (const std::domain_error& error) {
            throw app::UsageError{std::string{"--velocity: "} + error.what()};
        }
    }
    if (!(window_[0] < window_[1]))
        throw app::UsageError{"--window: " + app::option_text::shown(window_) +
                              " is not allowed; allowed: a,b with a < b"};
    if (!(window_[0] < diaphragm_ && diaphragm_ < window_[1]))
        throw app::UsageError{"--diaphragm: " + app::option_text::shown(diaphragm_) +
                              " is not allowed; allowed: inside the window " +
                              app::option_text::shown(window_)};
    scene.window = {window_[0], window_[1]};
    scene.diaphragm = diaphragm_;
    scene.equal_masses = spacing_ == "masses";
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
    report::tell(run, method);
    TubeScene tube_scene = scene(run);
    tube_scene.progress = run.progress();
    const TubeProblem problem = checked([&] { return kind_.problem(tube_scene); });
    const auto sides = checked([&] { return particles_of_sides(tube_scene, problem); });
    judge_sampling(run, tube_scene, problem, sides);
    const TubeRun tube = checked([&] { return run_tube(tube_scene, method, problem); });
    if (tube.profile.x.empty()) throw app::UsageError{"--time: the gas has left the window; allowed: less"};
    judge_result(run, tube_scene, problem.exact, tube);
    run.record(method.name, tube_scene.n,
               {{"particles_left", static_cast<double>(sides[0])},
                {"particles_right", static_cast<double>(sides[1])}});
    run.record(method.name, tube_scene.n, tube.errors());
    run.record(method.name, tube_scene.n, tube.drifts());
    run.record(method.name, tube_scene.n, tube.costs());
    run.record(method.name, tube_scene.n, {{"pairs", static_cast<double>(tube.counters.pairs)}});
    if (kind_.more) run.record(method.name, tube_scene.n, kind_.more(tube_scene, tube));
    const auto& [profile, exact] = std::tie(tube.profile, tube.exact);
    std::vector<std::pair<std::string, Column>> columns{
        {"x", profile.x},     {"rho", profile.rho}, {"v", profile.v},
        {"p", profile.p},     {"u", profile.u},     {"exact_rho", exact.rho},
        {"exact_v", exact.v}, {"exact_p", exact.p}, {"exact_u", exact.u}};
    for (const auto& [name, of_v] : kind_.columns) {
        for (const auto& [before, v] : {std::pair{"", &profile.v}, {"exact_", &exact.v}}) {
            columns.emplace_back(before + name, *v);
            std::transform(v->begin(), v->end(), columns.back().second.begin(), of_v);
        }
    }
    run.write("profile.csv", report::csv({columns.begin(), columns.end()}));
    draw(run, tube, exact_profile(problem.exact));
}

}  // namespace sph::shocks
