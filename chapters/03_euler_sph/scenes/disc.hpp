#pragma once
#include "chapters/03_euler_sph/gas.hpp"
#include "common/report/chapter.hpp"

/// A toy star in two dimensions that comes to rest (Monaghan 2005, 2.45 and figures 1-4): P = rho^2/4, linear
/// force, friction. At rest rho = 1 - r^2.
namespace sph::euler {

enum class DiscStart {
    random_equal,    ///< equal masses at random places of the unit disc
    lattice_varying  ///< a square lattice with masses rho times the cell
};

struct DiscScene {
    DiscStart start = DiscStart::random_equal;
    std::size_t n = 971;     ///< particles; on the lattice, about as many
    double h_over_dx = 1.1;  ///< h = h_over_dx sqrt(m/rho)
    double friction = 1;     ///< nu of (2.45)
    double time = 30;
    double courant = 0.3;
    std::uint64_t seed = 1;
    int threads = 1;
};

struct DiscRun {
    Columns<2> x, start_x;
    Column rho, m, h;
    double density_error = 0;          ///< relative L1 of rho against 1 - r^2, by mass
    double nearest = 0;                ///< mean distance of the nearest particle [spacings sqrt(m/rho)]
    double speed = 0;                  ///< root mean square at the end
    double momentum = 0;               ///< largest component over the mass
    Column function, gradient;         ///< r^2 exp(-6 r^2) by (2.8); d(r^2 - 1)/dx by (2.14)
    double function_error = 0;         ///< largest, relative to the largest value
    double gradient_error = 0;         ///< root mean square for r < 0.9
    double random_gradient_error = 0;  ///< the same before the particles moved
    Counters counters;

    report::Quantities measured() const;
};
DiscRun run_disc(const DiscScene& scene);

}  // namespace sph::euler
