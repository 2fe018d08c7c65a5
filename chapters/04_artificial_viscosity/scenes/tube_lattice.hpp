#pragma once
#include <random>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/core/groups.hpp"

/// Where the particles of a tube are at t = 0.
namespace sph::shocks {

/// Particles on both sides of the diaphragm, x = 0 here: first those that are free, from left to right, then
/// the layers beyond both ends, which are held and stand for more of the same gas.
struct TubeLattice {
    Column x;
    std::vector<std::size_t> side;  ///< of each: 0 is left, 1 is right
    std::size_t free = 0;
    std::vector<Group> layers;  ///< "left layer" and "right layer"; none beside a vacuum
    std::array<double, 2> m{};  ///< of a particle of either side
};

/// scene.n particles in the window; `rho` of both sides, 0 for a vacuum on one of them; `ends`, where each
/// begins and ends (< 0 and > 0; 0 for a vacuum); those that move are shifted at random by up to
/// scene.jitter (below 0.5) of their spacing. Throws std::invalid_argument if that takes more than ten
/// million on a side.
TubeLattice lay_tube(const TubeScene& scene, const std::array<double, 2>& rho,
                     const std::array<double, 2>& ends);

/// The share of the right state at x in a smoothed start of width d > 0: 1/(1 + e^(-x/d)), in 0..1.
double right_share(double x, double d);
/// Moves particles of equal masses, which stand for a jump of the density `rho` at x = 0, to where they stand
/// for a smoothed one of width d > 0: each keeps the mass on its left. Throws std::invalid_argument for a
/// vacuum.
void smooth_positions(TubeLattice& lattice, const std::array<double, 2>& rho, double d);

/// A number in [-1, 1), the same on every machine (which the distributions of the library are not).
inline double random_shift(std::mt19937_64& random) {
    return 2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1;
}

}  // namespace sph::shocks
