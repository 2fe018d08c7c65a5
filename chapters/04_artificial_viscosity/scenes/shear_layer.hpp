#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "common/report/chapter.hpp"

/// A wave of shear in the periodic unit box, v_x = V sin(2 pi y), rho = c_s = 1: nothing is compressed, and
/// without viscosity nothing changes. What is lost is what an artificial viscosity, or the noise of the
/// particles, takes.
namespace sph::shocks {

struct ShearScene {
    double gamma = 5.0 / 3, speed = 0.1, time = 4;  ///< V; c_s = 1
    std::size_t n = 32;                             ///< spacings in the box
    double nu = 0;                                  ///< KINEMATIC viscosity of the methods that have one
    Lattice lattice = Lattice::square;
    double courant = 0.3;
    int threads = 1;
};

struct ShearRun {
    Column t, amplitude;   ///< of the wave, 2 sum m v_x sin(2 pi y)/sum m, over V
    Columns<2> x;          ///< at the end
    Column v_x;            ///< of the particles at the end
    double h = 0;          ///< smoothing length at the start
    double viscosity = 0;  ///< nu of exp(-nu k^2 t) by least squares through the amplitudes [length^2/time]
    double first_viscosity = 0;  ///< over the first tenth of the time, while the particles are in order
    double noise = 0;            ///< root mean square of v_y at the end over V
    double energy_drift = 0;     ///< relative to the kinetic energy of the wave
    double momentum_drift = 0;   ///< relative to sum m |v|
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;  ///< viscosities in c_s h, noise, drifts, cpu_seconds
};

/// A method of viscous_methods() with the KINEMATIC viscosity nu; any other as it is.
Method<2> with_viscosity(Method<2> method, double nu);

/// Throws Unstable where the run leaves physics.
ShearRun run_shear(const ShearScene& scene, const Method<2>& method);

/// The same by finite volumes, n times n cells.
ShearRun run_shear_grid(const ShearScene& scene);

}  // namespace sph::shocks
