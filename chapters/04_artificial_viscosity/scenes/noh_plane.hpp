#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "common/report/chapter.hpp"

/// Noh's problem in the plane: cold gas of density 1 rushes to the origin with speed 1, and a shock stops it
/// that runs outwards with (gamma - 1)/2.
namespace sph::shocks {

struct NohScene {
    double gamma = 5.0 / 3, time = 0.6;
    double pressure = 1e-6;  ///< at the start; the exact solution has 0
    double radius = 1;       ///< of the gas at the start; its free edge is at radius - time at the end
    std::size_t n = 70;      ///< spacings in the radius
    Lattice lattice = Lattice::square;
    bool quarter = true;  ///< a quarter of the plane between mirrors (square lattice only), or all of it
    double courant = 0.3;
    long most_steps = 4000;  ///< more, and the run stops: steps that collapse would never end
    int threads = 1;
};

struct NohRun {
    Columns<2> x, v;              ///< at the end
    Column r, m, rho, v_r;        ///< of the particles
    double l1_rho = 0, l1_v = 0;  ///< relative, by area, over r < 0.9 (radius - time)
    double plateau = 0;           ///< mean density by area over 0.25 R < r < 0.75 R, R the shock's radius
    double centre = 0;            ///< the same over r < 0.1 R
    double scatter = 0;           ///< root mean square of rho/plateau - 1 over the plateau
    /// The shock's radius: where, coming from outside, the mean density (by mass, over rings half a spacing
    /// of the start wide) first rises through half of the exact one behind the shock. The exact one is R.
    double shock = 0;
    double energy_drift = 0;    ///< relative
    double momentum_drift = 0;  ///< relative to sum m |v| at the start; 0 between mirrors, which push
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;  ///< without the drifts, which grids have not measured
};

/// Throws Unstable where the run leaves physics, and std::invalid_argument for scenes that are none.
NohRun run_noh(const NohScene& scene, const Method<2>& method);

/// The same by finite volumes: n times n cells of the square (0, radius)^2, mirrors at x = 0 and y = 0. The
/// gas of the start fills the square, its corner beyond r = radius included, and through the other two sides
/// the exact state flows in: so there is no free edge. What flows in moves with speed 1, and stays beyond
/// r = radius - time: the errors do not see it. `x` are centres, `m` the cells' masses.
NohRun run_noh_grid(const NohScene& scene, std::size_t n);

}  // namespace sph::shocks
