#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "common/exact/two_layer.hpp"
#include "common/report/chapter.hpp"

/// Plane Couette flow of two fluids in layers: the wall y = 0 stands still, the wall y = 1 moves with V = 1
/// along x, rho = 1, and mu jumps at the interface. It begins with the straight line of one fluid, and runs
/// until it is steady, against the exact solution of incompressible fluids.
namespace sph::shocks {

/// What the rows of held particles beyond a wall do. `continued`: each moves as the exact flow would there,
/// so that a wall adds no error of its own and all that is seen is the interface's. `rigid`: all with the
/// wall's velocity.
enum class Walls { continued, rigid };

struct LayersScene {
    double viscosity = 0.1;  ///< mu of the lower layer, DYNAMIC
    double ratio = 10;       ///< mu of the upper layer over that of the lower one
    double interface = 0.5;  ///< where it lies; n * interface is whole, and either layer has 8 rows
    double gamma = 5.0 / 3;
    double mach = 0.1;        ///< V/c_s at first; friction heats the gas by parts of mach^2
    double fadings = 10;      ///< how long: times in which what is not steady falls by about e
    std::size_t n = 32;       ///< rows from wall to wall
    std::size_t columns = 4;  ///< particles in the period; rows stay rows, so that 8 give the same digits
    double jitter = 0;        ///< random shift of each free particle, up to this part of its spacing
    Walls walls = Walls::continued;
    double courant = 0.3;
    int threads = 1;

    double time() const;  ///< fadings (2 or 1 times a thickness/pi)^2/nu, of the slower layer
    exact::TwoLayer solution() const;
};

struct LayersRun {
    Column y, v;      ///< of the free particles at the end
    double l1_v = 0;  ///< relative
    /// Velocity above the interface less that below it, over V: of straight lines through either layer as
    /// far as no particle sees the other one.
    double slip = 0;
    double lower_stress = 0,
           upper_stress = 0;    ///< mu times the slopes of these, over the exact stress, less 1
    double unsteady = 0;        ///< by which part of its mean v changed in the last tenth of the time
    double energy_drift = 0;    ///< of the total energy, relative to V^2/2 of all particles
    double momentum_drift = 0;  ///< along x, relative to V of all particles
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;
};

/// A method of layered_methods(). Throws Unstable where the run leaves physics, std::invalid_argument for an
/// interface that does not lie between rows, or layers that are too thin.
LayersRun run_layers(const LayersScene& scene, const Method<2>& method);

}  // namespace sph::shocks
