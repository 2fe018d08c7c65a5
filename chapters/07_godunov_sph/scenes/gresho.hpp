#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "common/report/chapter.hpp"

/// Gresho's vortex in a periodic square of side 1: V = 1, R = 0.2, rho = 1. Nothing should change.
namespace sph::godunov {

struct GreshoScene {
    double gamma = 1.4, pressure = 5;  ///< at the centre; the fastest gas has the Mach number 0.36
    double time = 1;                   ///< R turns once in 1.26
    std::size_t n = 32;                ///< spacings in the side
    shocks::Lattice lattice = shocks::Lattice::square;
    double courant = 0.3;
    int threads = 1;
};

struct GreshoRun {
    Columns<2> x;               ///< at the end, in -1/2..1/2
    Column r, v;                ///< of the particles, and their velocities around the origin
    double l1_v = 0;            ///< relative, of v, by volume, over r < 1/2
    double peak = 0;            ///< mean of v over 0.18 < r < 0.22, over the exact one
    double noise = 0;           ///< rms velocity along r, over r < 0.4
    double kinetic = 0;         ///< energy at the end over that of the start
    double energy_drift = 0;    ///< relative
    double momentum_drift = 0;  ///< relative to sum m |v| at the start
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;
};
/// Throws Unstable where the run leaves physics.
GreshoRun run_gresho(const GreshoScene& scene, const shocks::Method<2>& method);
/// The same by finite volumes, n times n cells.
GreshoRun run_gresho_grid(const GreshoScene& scene);

}  // namespace sph::godunov
