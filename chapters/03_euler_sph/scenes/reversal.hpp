#pragma once
#include <string>

#include "chapters/03_euler_sph/scenes/wave.hpp"

/// The oscillation of Monaghan 2005, section 6.1: a finite wave, run forward, its velocities reversed, and
/// run for as many steps again. Equations that come from a Lagrangian can return; which integrators let them?
namespace sph::euler {

inline std::vector<std::string> reversal_integrators() {
    return {"kick-drift-kick", "drift-kick-drift", "reversible steps", "fixed point", "RK4", "naive steps"};
}

struct ReversalRun {
    double velocity_error = 0;  ///< L2 of v + v(0), relative to v(0)
    double position_error = 0;  ///< root mean square of x - x(0) [spacings]
    double energy_drift = 0;    ///< largest, relative to the wave's energy
    bool bitwise = false;       ///< positions came back to the last bit
    double time = 0;            ///< of one way [periods]
    Column x, v, start_v;       ///< at the end; -v is expected
};

/// 2 `steps` steps of dt = 13.7/4000 periods, reversed in the middle; steps that vary follow the least h/c_s.
/// Fixed h = 1.3 spacings, cubic spline, gamma = 1.4, velocity 0.05 c_s sin(2 pi waves x).
ReversalRun run_reversal(const std::string& integrator, int waves, int steps = 2000, std::size_t n = 100);

}  // namespace sph::euler
