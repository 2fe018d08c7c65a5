#pragma once
#include <functional>
#include <string>
#include <vector>

#include "chapters/09_transverse_expansion/discs.hpp"
#include "chapters/09_transverse_expansion/scenes/flow.hpp"
#include "common/core/integrated.hpp"
#include "common/report/chapter.hpp"
#include "common/report/method.hpp"

/// A flow on particles of the transverse plane, and how far it is from the exact one.
namespace sph::transverse {

enum class Places { hexagonal, rings, relaxed, spiral, graded };
/// Runge-Kutta of fourth or of second order.
enum class Order { fourth, second };

struct PlaneSetup {
    std::size_t n = 0;  ///< particles that are asked for
    double radius = 1;  ///< of the disc that they fill
    double c2 = 1.0 / 3;
    Columns<2> x{};  ///< where they begin
    double courant = 0.7;
    Order order = Order::fourth;
    bool careful = true;  ///< steps that grow from a small one and know tau
    int threads = 1;
};
/// How the plane is resolved. h_over_dx counts in sqrt(nu/s*), or, where h is fixed, in the mean spacing at
/// the start.
struct PlaneMethod : report::Method<Integrated<2>, PlaneSetup> {
    Places places = Places::graded;
    bool solved = false;  ///< masses are solved so that s* is right at the start, also at the edge
};
/// From the naive one to the recommended one.
const report::Methods<PlaneMethod>& plane_methods();

/// What the sums make of the masses: the entropy of each particle is changed until s*_i is `wanted`, in three
/// rounds of at most 30 per cent each; 0 < total: then everything is scaled so that the whole entropy is that
/// and s* the same. Needs start() before the march.
void solve_masses(Integrated<2>& fluid, const Column& wanted, double tau, double total);

/// Random places in the disc that relax as chapter 3's disc does: a gas P = rho^2/4 with friction, between
/// mirror images beyond the circle.
Disc relaxed_disc(std::size_t n, double R, std::uint64_t seed, int threads);

struct PlaneScene {
    std::size_t n = 10000;
    std::vector<double> times;  ///< increasing, > tau0
    double courant = 0.7;       ///< step over the time in which sound crosses an h
    Order order = Order::fourth;
    bool careful = true;
    long steps = 0;  ///< > 0: so many equal steps to each of the times
    std::uint64_t seed = 1;
    int threads = 1;
    std::function<void(double share)> progress{};
};

struct Snapshot {
    double time = 0;
    Column x, y, r, temperature, u_r, eps;  ///< of the particles
    Column exact_temperature, exact_u_r, exact_eps;
    Column area, h;
    /// By area in r < window: sum |f - f_exact| dA/sum f_exact dA; l1_u is 0 where nothing moves.
    double l1_temperature = 0, l1_eps = 0, l1_u = 0;
    double axis = 0;      ///< largest |T/T_exact - 1| in r < window/10
    double momentum = 0;  ///< |sum nu (q - q(tau0))|/sum nu |q|
    double entropy = 0;   ///< sum nu over the exact one, less 1; 0 where the flow has no edge
    double seconds = 0;   ///< CPU time of the steps until here
    Counters counters;

    report::Quantities measured() const;
};

/// Throws Unstable where the run leaves physics. Cost: four evaluations a step.
std::vector<Snapshot> run_plane(const Flow& flow, const PlaneScene& scene, const PlaneMethod& method);

/// The fluid at tau0, ready to march.
std::unique_ptr<Integrated<2>> plane_fluid(const Flow& flow, const PlaneScene& scene,
                                           const PlaneMethod& method);
/// What it looks like at a resolved state at tau.
Snapshot snapshot_of(const Integrated<2>& fluid, const Flow& flow, double tau);

}  // namespace sph::transverse
