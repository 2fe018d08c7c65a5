#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "common/report/chapter.hpp"

/// Sedov's blast in the plane: the energy 1 at the origin of a cold gas of density 1, spread over a kernel.
namespace sph::shocks {

struct SedovScene {
    double gamma = 5.0 / 3;
    double radius = 0.4;     ///< of the exact shock at the end; faces are at 0.5
    double pressure = 1e-6;  ///< of the cold gas; the exact solution has 0
    double blast_width = 4;  ///< smoothing length of the cubic spline that spreads the energy, in spacings
    std::size_t n = 60;      ///< spacings in the length 0.5
    Lattice lattice = Lattice::square;
    bool quarter = true;  ///< 0..0.5 between mirrors (square lattice only), or all in a periodic box
    double courant = 0.3;
    long most_steps = 4000;  ///< more, and the run stops: steps that collapse would never end
    int threads = 1;
};

struct SedovRun {
    Columns<2> x;                           ///< at the end
    Column r, m, rho, v_r, p;               ///< of the particles
    double time = 0;                        ///< of the end
    double l1_rho = 0, l1_v = 0, l1_p = 0;  ///< relative, by area, over r < 0.45
    double shock_radius = 0;    ///< where the mean density of rings falls through 1 + half its peak's excess
    double peak = 0;            ///< the largest mean density of a ring, over the exact one
    double energy_drift = 0;    ///< relative
    double momentum_drift = 0;  ///< relative to sum m |v| at the end; 0 between mirrors, which push
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;  ///< without the drifts, which grids have not measured
};

/// Throws Unstable where the run leaves physics, and std::invalid_argument for scenes that are none.
SedovRun run_sedov(const SedovScene& scene, const Method<2>& method);

/// The same by finite volumes, on n times n cells of the quarter, from the same energies.
SedovRun run_sedov_grid(const SedovScene& scene);

}  // namespace sph::shocks
