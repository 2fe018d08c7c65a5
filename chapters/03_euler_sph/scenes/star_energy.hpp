#pragma once
#include "chapters/03_euler_sph/scenes/star.hpp"

/// The energy of a star that oscillates for long, by several integrators.
namespace sph::euler {

inline std::vector<std::string> star_integrators() {
    return {"kick-drift-kick", "drift-kick-drift", "reversible steps", "naive steps", "RK4"};
}

struct EnergyHistory {
    Column t, change;      ///< relative change of the energy, some hundred samples
    double amplitude = 0;  ///< half the range of the change over one period
    double shadow = 0;     ///< the same of the shadow Hamiltonian; of kick-drift-kick only
    double drift = 0;      ///< linear fit over the whole run, through means over whole periods
    double momentum = 0;   ///< largest, by mass and the amplitude of the velocity
    double dt = 0;
    long steps = 0;
};

/// `steps` steps of `courant` times the least spacing/c_s of the star at rest, which starts with v = A_0 x.
/// The relaxed star, consistent h, h = 1.2 spacings.
EnergyHistory run_star_energy(const StarScene& scene, const std::string& integrator, double A_0,
                              double courant, long steps, const std::string& kernel = "cubic");

/// A star whose pressure force does not conserve momentum (3.5), and the same with (3.8).
struct CentreRun {
    Column t, centre;                              ///< of mass, with the force (3.5)
    Column conserving_t, conserving_centre;        ///< with (5.8)
    double momentum = 0, conserving_momentum = 0;  ///< largest, by mass and amplitude
};
/// Started with the velocity of mode 3 and amplitude `amplitude`. Throws Unstable.
CentreRun run_centres(const StarScene& scene, double amplitude, double time);

}  // namespace sph::euler
