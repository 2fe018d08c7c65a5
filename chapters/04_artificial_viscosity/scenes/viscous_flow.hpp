#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "common/report/chapter.hpp"

/// Decaying Taylor-Green vortices in the periodic unit square: rho = 1, the largest speed V = 1, a speed of
/// sound of 1/mach, against the exact solution of the incompressible fluid.
namespace sph::shocks {

struct VortexScene {
    double gamma = 7;   ///< stiff: the background pressure rho c_s^2/gamma drives the noise of the particles
    double mach = 0.1;  ///< V/c_s; compressibility changes the decay by parts of mach^2
    double reynolds = 20;  ///< V L/nu: nu = 1/reynolds, kinematic
    double time = 0.25;
    std::size_t n = 32;  ///< spacings in the side
    Lattice lattice = Lattice::hexagonal;
    double courant = 0.3;
    int threads = 1;
};

struct VortexRun {
    Column t, energy;           ///< kinetic, mean over the square by mass
    Columns<2> x, v;            ///< at the end
    double l2_v = 0;            ///< relative, of the velocities at the end
    double decay_rate = 0;      ///< of the velocity, by least squares through the logarithms of the energy
    double exact_rate = 0;      ///< 2 nu k^2
    double energy_drift = 0;    ///< of the total energy, relative to the kinetic one at the start
    double momentum_drift = 0;  ///< relative to sum m |v|
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps
};

/// Throws Unstable where the run leaves physics.
VortexRun run_vortex(const VortexScene& scene, const Method<2>& method);

/// The same by finite volumes, n times n cells.
VortexRun run_vortex_grid(const VortexScene& scene);

}  // namespace sph::shocks
