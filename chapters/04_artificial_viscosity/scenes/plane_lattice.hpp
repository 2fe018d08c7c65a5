#pragma once
#include "common/core/vec.hpp"
#include "common/exact/finite_volume_2d.hpp"

/// Where the particles of a plane begin, and how a field of particles is seen from the origin.
namespace sph::shocks {

enum class Lattice { square, hexagonal };

struct Placed {
    Columns<2> x;
    double spacing = 0;  ///< the root of the area of a particle
};
/// Points that fill the rectangle `low`..`high` evenly, also across its faces where these are periodic, about
/// `per_unit` in a length of 1. The square lattice is symmetric in mirrors at the faces, the hexagonal one is
/// not. per_unit > 0.
Placed make_lattice(Lattice lattice, const Vector<2>& low, const Vector<2>& high, double per_unit);

/// Throws std::invalid_argument for a quarter of the plane with a lattice that is not its own mirror image.
void require_lattice(Lattice lattice, bool quarter);

/// The cells of a grid as if they were particles: their centres, velocities, masses, densities, pressures.
struct GridColumns {
    Columns<2> x, v;
    Column m, rho, p;
};
GridColumns columns_of(const exact::GasGrid& grid);

/// Each particle's distance from the origin, and the component of v away from it.
Column radii(const Columns<2>& x);
Column radial(const Columns<2>& x, const Columns<2>& v);

/// Means over rings around the origin.
struct Rings {
    Column r, value;
};
/// Means of f with the weights w in rings of width dr up to r_end, and at the mean r of these; rings without
/// particles are left out.
Rings ring_means(const Column& r, const Column& f, const Column& w, double dr, double r_end);
/// Where, coming from outside, the means first rise through `level`: between two rings, linearly; 0 if
/// nowhere.
double outermost_rise(const Rings& rings, double level);

}  // namespace sph::shocks
