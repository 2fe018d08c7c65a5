#pragma once
#include <string>

#include "chapters/03_euler_sph/gas.hpp"

/// What each form of the equations conserves: a sound wave in a periodic box in two dimensions, on jittered
/// particles, so that nothing cancels by symmetry.
namespace sph::euler {

/// (3.5) with summed density.
template <class K>
struct NonConservingForm : FixedH<K> {
    using Force = NonConservingForce;
};
/// The force of one Phi with the density equation of another.
template <class K, class ForcePhi, class DensityPhi>
struct MixedForm : ContinuityH<K, DensityPhi> {
    using Force = PressureForce<ForcePhi>;
};

struct FormRun {
    std::string name, density, force;
    double momentum = 0;     ///< largest change of a component, over sum m |v| at t = 0
    Column courant, energy;  ///< change of the energy at the end, relative to the motion at t = 0, and the
                             ///< time step [h/c_s] that it was reached with
};
/// `per_side`^2 particles with jitter 0.2, Mach 0.3, RK4 with each of the time steps.
std::vector<FormRun> run_forms(const Column& courants, std::size_t per_side = 24, double time = 1,
                               std::uint64_t seed = 1, int threads = 1);

/// What each density equation says of the velocity v and the exact density at one particle of a line.
struct DensityForms {
    double summed = 0, normalised = 0;               ///< (164), (165) over the exact density
    double plain = 0, differences = 0, by_mass = 0;  ///< (166), (167), (168): d rho/dt over the exact density
};
/// Where on a line of 41 even particles (cubic spline, h = 1.2 dx) the density is asked for.
enum class OnLine { inside, end, light_side };  ///< light_side: next to gas that is ten times as dense
/// v = 1, or v = x if `expanding`, which makes d rho/dt = -rho.
DensityForms density_forms(OnLine place, bool expanding);

/// Which equation moves the energy.
enum class EnergyForm {
    own,           ///< thermal, each by its own pressure (3.14)
    shared,        ///< thermal, half of a pair's work to each (Chen 2017, 172)
    thermokinetic  ///< v^2/2 + u (3.18), from which u is taken
};
/// The same flow of an ideal gas by RK2, its pressure from that energy. `energy`: how far the sum of
/// m (v^2/2 + u) is from its start, relative to the motion at t = 0; `entropy`: root mean square over the
/// particles of the relative change of P/rho^gamma, which should be none.
struct EnergyRun {
    double energy = 0, entropy = 0;
};
EnergyRun run_energies(EnergyForm form, double courant, std::size_t per_side = 24, double time = 1,
                       std::uint64_t seed = 1);

}  // namespace sph::euler
