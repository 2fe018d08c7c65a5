#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "common/exact/shear_instability.hpp"
#include "common/report/chapter.hpp"

/// Kelvin and Helmholtz: two streams that slide along each other, in a periodic square of side 1, disturbed
/// by the fastest mode of the linear theory. It should grow as that says.
namespace sph::godunov {

struct SlidingScene {
    exact::ShearInstability::Flow flow{};
    double amplitude = 0.01;  ///< largest v_y at the start
    double time = 1;          ///< 1.7 times 1/growth with the flow above
    std::size_t n = 32;       ///< spacings in the side
    double courant = 0.3;
    int threads = 1;
};

struct SlidingRun {
    Column t, amplitude;      ///< of the mode, by projection of v_y by volume; it begins with 1
    double theory = 0;        ///< growth of the linear theory [1/time]
    double growth = 0;        ///< of a line through the logarithms, over the second half of the time
    Columns<2> x;             ///< at the end, in 0..1
    Column rho;               ///< of the particles at the end
    double energy_drift = 0;  ///< relative
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;
};
/// Throws Unstable where the run leaves physics.
SlidingRun run_sliding(const SlidingScene& scene, const shocks::Method<2>& method);
/// The same by finite volumes, n times n cells.
SlidingRun run_sliding_grid(const SlidingScene& scene);

}  // namespace sph::godunov
