#pragma once
#include <array>
#include <functional>
#include <limits>

#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "common/exact/riemann.hpp"
#include "common/report/chapter.hpp"

/// A tube of gas: two uniform states that meet at x = 0, followed until `time`, against the exact solution.
namespace sph::shocks {

struct TubeScene {
    exact::Riemann::State left{1, 0, 1}, right{0.125, 0, 0.1};  ///< rho, v, p; vacuum where rho = 0
    double gamma = 1.4, time = 0.2;
    std::size_t n = 720;     ///< equal masses in |x| < 0.5 at t = 0
    double jitter = 0;       ///< random shift of each particle, up to this part of its spacing; below 0.5
    unsigned long seed = 1;  ///< of the shifts
    double courant = 0.45;
    int threads = 1;
    long most_steps = std::numeric_limits<long>::max();  ///< a run that needs more is stopped as unstable
    std::function<void(double share)> progress{};
};

/// The velocity of a wave's edge, which relativistic solutions keep with its rapidity.
double speed(const auto& edge) {
    if constexpr (requires { edge.v; }) {
        return edge.v;
    } else {
        return edge;
    }
}
/// The exact solution at the end of a tube: what comparisons need of it.
struct ExactTube {
    std::function<exact::Riemann::Point(double x)> at;
    double p_star = 0, contact = 0;  ///< pressure between the waves, and where the contact is
    bool vacuum = false;             ///< then there is no contact
    std::vector<double> jumps{};     ///< where shocks and contact are
};
template <class Solution>
ExactTube exact_tube(const Solution& solution, double time) {
    const auto& star = solution.star();
    ExactTube tube{[solution, time](double x) {
                       const auto point = solution.at(x, time);
                       return exact::Riemann::Point{point.rho, point.v, point.p, point.u};
                   },
                   star.p, star.v * time, star.vacuum};
    const auto& waves = solution.waves();
    for (const auto& wave : {waves.left, waves.right}) {
        if (wave.shock) tube.jumps.push_back(speed(wave.head) * time);
    }
    if (!star.vacuum) tube.jumps.push_back(tube.contact);
    return tube;
}

/// The physics of a tube, Newtonian or relativistic: what laying it out and judging it takes.
struct TubeProblem {
    ThermalState state;
    std::array<double, 2> density;  ///< of mass by length, on the left and on the right; 0: vacuum
    /// Where the gas of the two sides begins and ends at t = 0 so that no wave reaches an end and |x| < 0.5
    /// is filled at the end of the scene; 0 for a vacuum.
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
/// What is wrong with a scene for any gas: jitter, time, gas without pressure. Throws std::invalid_argument.
void require_tube(const TubeScene& scene);

struct Profile {
    Column x, rho, v, p, u;
};
struct TubeRun {
    Profile whole;           ///< of all free particles at the end, in order
    Profile profile, exact;  ///< of those in |x| < 0.5
    /// Relative L1 over |x| < 0.5: sum |f - f_exact| dx / sum |f_exact| dx, dx half the distance of a
    /// particle's neighbours.
    double l1_rho = 0, l1_v = 0, l1_p = 0, l1_u = 0;
    double overshoot = 0;     ///< the largest density over the largest exact one, less 1; 0 at least
    double wiggle = 0;        ///< the largest |P/P_star - 1| of the six particles on each side of the contact
    double energy_drift = 0;  ///< relative
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
Profile exact_profile(const ExactTube& solution, double low = -0.5, double high = 0.5);
/// The same for a scene's.
Profile exact_profile(const TubeScene& scene, double low = -0.5, double high = 0.5);
/// dx of each of the ordered particles: half the distance of its neighbours, all of it at an end.
Column spacings(const Column& x);

}  // namespace sph::shocks
