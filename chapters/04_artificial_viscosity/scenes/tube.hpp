#pragma once
#include <array>
#include <functional>
#include <limits>

#include "chapters/04_artificial_viscosity/scenes/model.hpp"
#include "common/exact/riemann.hpp"

/// A tube of gas: two uniform states that meet at x = 0, followed until `time`, against the exact solution.
namespace sph {

struct TubeScene {
    exact::Riemann::State left{1, 0, 1}, right{0.125, 0, 0.1};  ///< rho, v, p; vacuum where rho = 0
    double gamma = 1.4, time = 0.2;
    std::size_t n = 720;     ///< equal masses in |x| < 0.5 at t = 0
    double jitter = 0;       ///< random shift of each particle, up to this part of its spacing; below 0.5
    unsigned long seed = 1;  ///< of the shifts
    double courant = 0.45;
    int threads = 1;
    long most_steps = std::numeric_limits<long>::max();  ///< a run that needs more is stopped as unstable
};

struct Profile {
    Column x, rho, v, p, u;
};
struct TubeRun {
    Profile profile, exact;  ///< of the particles in |x| < 0.5 at the end, in order
    /// Relative L1 over |x| < 0.5: sum |f - f_exact| dx / sum |f_exact| dx, dx half the distance of a
    /// particle's neighbours.
    double l1_rho = 0, l1_v = 0, l1_p = 0, l1_u = 0;
    double overshoot = 0;     ///< the largest density over the largest exact one, less 1; 0 at least
    double wiggle = 0;        ///< the largest |P/P_star - 1| of the six particles on each side of the contact
    double energy_drift = 0;  ///< relative
    double momentum_drift = 0;  ///< relative to sum m (|v| + c_s) at the start
    double seconds = 0;         ///< CPU time of the steps, of one thread
    Counters counters;
};

/// Throws Unstable where the run leaves physics, particles that overtake each other included, and
/// std::invalid_argument for scenes that are none.
TubeRun run_tube(const TubeScene& scene, const Method& method);

/// Where the gas of the two sides begins and ends at t = 0 so that no wave reaches an end and |x| < 0.5 is
/// filled at the end of the scene; 0 for a vacuum.
std::array<double, 2> tube_ends(const TubeScene& scene);
/// The exact solution at the end of a tube, Newtonian or relativistic: what comparisons need of it.
struct ExactTube {
    std::function<exact::Riemann::Point(double x)> at;
    double p_star = 0, contact = 0;  ///< pressure between the waves, and where the contact is
    bool vacuum = false;             ///< then there is no contact
};
template <class Solution>
ExactTube exact_tube(const Solution& solution, double time) {
    const auto& star = solution.star();
    return {[solution, time](double x) {
                const auto point = solution.at(x, time);
                return exact::Riemann::Point{point.rho, point.v, point.p, point.u};
            },
            star.p, star.v * time, star.vacuum};
}
/// Fills the errors, overshoot and wiggle of run.profile against the exact solution beside it, for |x| < 0.5;
/// `dx` are the widths of its points.
void compare(TubeRun& run, const Column& dx, const ExactTube& solution);
/// The exact solution on 1001 even points in [low, high], for figures: a line through the particles' own
/// places would cut the corners.
Profile exact_profile(const ExactTube& solution, double low = -0.5, double high = 0.5);
/// The same for a scene's.
Profile exact_profile(const TubeScene& scene, double low = -0.5, double high = 0.5);
/// Throws Unstable at time t unless x[0] < x[1] < ... for the first n particles.
void require_order(const Column& x, std::size_t n, double t);
/// dx of each of the ordered particles: half the distance of its neighbours, all of it at an end.
Column spacings(const Column& x);

}  // namespace sph
