#pragma once
#include <array>
#include <functional>
#include <limits>

#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "common/exact/riemann.hpp"
#include "common/report/chapter.hpp"

/// A tube of gas: two uniform states that meet at a diaphragm, followed until `time`, against the exact
/// solution.
namespace sph::shocks {

struct TubeScene {
    exact::Riemann::State left{1, 0, 1}, right{0.125, 0, 0.1};  ///< rho, v, p; vacuum where rho = 0
    double gamma = 1.4, time = 0.2;
    std::size_t n = 720;     ///< particles in the window at t = 0
    double jitter = 0;       ///< random shift of each particle, up to this part of its spacing; below 0.5
    unsigned long seed = 1;  ///< of the shifts
    double courant = 0.45;
    int threads = 1;
    long most_steps = std::numeric_limits<long>::max();  ///< a run that needs more is stopped as unstable
    std::function<void(double share)> progress{};
    std::function<void(double t, const Simulation<1>& gas)> watch{};  ///< called after each step
    std::array<double, 2> window{-0.5, 0.5};  ///< of x, where it is compared and drawn
    double diaphragm = 0;                     ///< where the states meet; inside the window
    bool equal_masses = true;                 ///< else the same spacing on both sides
    /// Width d [length] of a smoothed start, A = (A_L + A_R e^(x/d))/(1 + e^(x/d)) for rho, v and P/rho
    /// (Monaghan 1997, J. Comput. Phys. 136, 298); 0: a jump. Needs equal masses and no vacuum.
    double smoothing = 0;
};

/// The velocity of a wave's edge, which relativistic solutions keep with its rapidity.
double speed(const auto& edge) {
    if constexpr (requires { edge.v; }) {
        return edge.v;
    } else {
        return edge;
    }
}
/// What is on the way at the end of a tube: "left shock", "right fan's head", "contact".
struct Edge {
    std::string name;
    double x;
};
/// The exact solution at the end of a tube: what comparisons need of it.
struct ExactTube {
    std::function<exact::Riemann::Point(double x)> at;
    std::array<double, 2> window;    ///< where it is compared
    double p_star = 0, contact = 0;  ///< pressure between the waves, and where the contact is
    double p_outside = 0;            ///< the smaller pressure of both sides at the start
    bool vacuum = false;             ///< then there is no contact
    std::vector<Edge> edges{};       ///< of both waves, and the contact
    std::vector<double> jumps{};     ///< where shocks and contact are
    /// What an error is relative to where there is no field to speak of: the larger density and pressure of
    /// both sides, the larger speed of sound and its square.
    exact::Riemann::Point scale{};
};
/// sound_speed(state): of either side at the start.
template <class Solution, class SoundSpeed>
ExactTube exact_tube(const Solution& solution, const TubeScene& scene, SoundSpeed&& sound_speed) {
    const auto& star = solution.star();
    const auto& waves = solution.waves();
    const auto place = [&](const auto& edge) { return scene.diaphragm + speed(edge) * scene.time; };
    const double c = std::max(sound_speed(scene.left), sound_speed(scene.right));
    const auto [rho, p] =
        std::pair{std::max(scene.left.rho, scene.right.rho), std::max(scene.left.p, scene.right.p)};
    ExactTube tube{
        .at =
            [solution, scene](double x) {
                const auto point = solution.at(x - scene.diaphragm, scene.time);
                return exact::Riemann::Point{point.rho, point.v, point.p, point.u};
            },
        .window = scene.window,
        .p_star = star.p,
        .contact = scene.diaphragm + star.v * scene.time,
        .p_outside = std::min(scene.left.rho > 0 ? scene.left.p : p, scene.right.rho > 0 ? scene.right.p : p),
        .vacuum = star.vacuum,
        .scale = {rho, c, p, c * c}};
    for (const auto& [side, wave, state] :
         {std::tuple{"left ", waves.left, scene.left}, {"right ", waves.right, scene.right}}) {
        constexpr double no_wave = 1e-9;
        if (state.rho == 0 || std::abs(star.p - state.p) <= no_wave * state.p) continue;
        if (wave.shock) {
            tube.jumps.push_back(place(wave.head));
            tube.edges.push_back({std::string{side} + "shock", place(wave.head)});
        } else {
            tube.edges.push_back({std::string{side} + "fan's head", place(wave.head)});
            tube.edges.push_back({std::string{side} + "fan's tail", place(wave.tail)});
        }
    }
    if (!star.vacuum) {
        tube.jumps.push_back(tube.contact);
        tube.edges.push_back({"contact", tube.contact});
    }
    return tube;
}

/// The physics of a tube, Newtonian or relativistic: what laying it out and judging it takes.
struct TubeProblem {
    ThermalState state;
    std::array<exact::Riemann::State, 2> sides;  ///< what the gas begins with; cold gas has a little heat
    std::array<double, 2> density;  ///< of mass by length, on the left and on the right; 0: vacuum
    /// Where the gas of the two sides begins and ends at t = 0, seen from the diaphragm, so that no wave
    /// reaches an end and the window is filled at the end of the scene; 0 for a vacuum.
    std::array<double, 2> ends;
    std::array<double, 2> momentum;  ///< by mass, that drifts are compared with: |v| + c_s of either side
    ExactTube exact;
};
/// Of an ideal gas. Throws std::invalid_argument for scenes that are none.
TubeProblem gas_tube(const TubeScene& scene);

/// How far a side must reach that begins in `state`; side = -1: left, 1: right; `head` is the velocity of its
/// outermost wave, `reserve` >= 1 times as far as which a smeared wave may run.
double tube_end(const TubeScene& scene, const exact::Riemann::State& state, double side, double head,
                double reserve);
/// What is wrong with a scene for any gas: jitter, time, window. Throws std::invalid_argument.
void require_tube(const TubeScene& scene);
/// The scene with what stands for gas without pressure, which would have no time step: 1e-12 of the larger of
/// the other pressure and of rho (v_L - v_R)^2, or `least` by rho. Throws std::invalid_argument if that is 0.
TubeScene with_heat(TubeScene scene, double least = 0);
/// How many particles each side has in the window at the start.
std::array<std::size_t, 2> particles_of_sides(const TubeScene& scene, const TubeProblem& problem);

struct Profile {
    Column x, rho, v, p, u;
};
struct TubeRun {
    Profile whole;           ///< of all free particles at the end, in order
    Profile profile, exact;  ///< of those in the window
    /// Relative L1 over the window: sum |f - f_exact| dx / sum |f_exact| dx, dx half the distance of a
    /// particle's neighbours. Where the exact field is below a thousandth of its scale (v of a contact at
    /// rest), to the scale.
    double l1_rho = 0, l1_v = 0, l1_p = 0, l1_u = 0;
    double overshoot = 0;  ///< the largest density over the largest exact one, less 1; 0 at least
    /// The largest |P - P_star| of the six particles on each side of the contact, over P_star, or over the
    /// smaller pressure of both sides where that is larger (between fans P_star may be next to nothing).
    double wiggle = 0;
    double energy_drift = 0;    ///< relative
    double momentum_drift = 0;  ///< relative to sum m (|v| + c_s) at the start
    double seconds = 0;         ///< CPU time of the steps
    Counters counters;

    report::Quantities errors() const;  ///< l1_rho, l1_v, l1_p, l1_u, overshoot_rho, wiggle_p
    report::Quantities drifts() const;  ///< of energy and momentum; grids have not measured them
    report::Quantities costs() const;   ///< steps, cpu_seconds
};

/// Throws Unstable where the run leaves physics, particles that overtake each other included, and
/// std::invalid_argument for scenes that are none.
TubeRun run_tube(const TubeScene& scene, const Method<1>& method, const TubeProblem& problem);
TubeRun run_tube(const TubeScene& scene, const Method<1>& method);

/// Fills profile, exact, errors, overshoot and wiggle from run.whole; `dx` are the widths of its points.
void compare(TubeRun& run, const Column& dx, const ExactTube& solution);
/// The exact solution on 201 even points of [low, high] and on both sides of each jump, for figures: a line
/// through the particles' own places would cut the corners.
Profile exact_profile(const ExactTube& solution, double low, double high);
Profile exact_profile(const ExactTube& solution);  // of its window
/// The same for a scene's.
Profile exact_profile(const TubeScene& scene, double low = -0.5, double high = 0.5);
/// P/rho^gamma, which stands for the entropy: of a gas element only a shock may change it, and only upwards.
Column entropy_of(const Profile& profile, double gamma);
/// dx of each of the ordered particles: half the distance of its neighbours, all of it at an end.
Column spacings(const Column& x);

}  // namespace sph::shocks
