#pragma once
#include <optional>

#include "chapters/04_artificial_viscosity/scenes/hard_cases.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube_command.hpp"
#include "common/exact/relativistic_riemann.hpp"

/// A tube of relativistic gas with baryons, c = 1: chapter 4's scene, with rest densities.
namespace sph::landau {

using shocks::TubeRun;
using shocks::TubeScene;
using TubeMethod = shocks::Method<1>;

/// The methods, from none over the classical to the recommended one.
const shocks::Methods<1>& relativistic_methods();

/// The physics of the scene: `n` particles of equal baryon number (lab-frame density times length) in |x| <
/// 0.5. rho, v, p of scene.left, scene.right are rest density, velocity in (-1, 1) and pressure; gamma in (1,
/// 2]. Throws std::invalid_argument for scenes that are none: among them gas so cold that its heat is lost
/// beside its energy, p/rho below 1e-13 lorentz^2.
shocks::TubeProblem relativistic_tube(const TubeScene& scene);
/// The exact solution of the scene.
exact::RelativisticRiemann relativistic_solution(const TubeScene& scene);
shocks::ExactTube exact_relativistic_tube(const TubeScene& scene);

/// Throws Unstable where the run leaves physics.
TubeRun run_relativistic_tube(const TubeScene& scene, const TubeMethod& method);

/// What is followed of a shock besides the errors of a TubeRun.
struct Shock {
    double place;  ///< where the outermost density of its wave crosses the mean of both its sides
    double error;  ///< over the way from the diaphragm; over a hundredth of the window if it has gone less
    double peak;   ///< largest density behind it over the exact one
};
/// One that a run does not have: all of its way is missing.
constexpr Shock nowhere{0, 1, 0};
/// Of the wave on one side (-1 left, 1 right). None where the exact solution has no shock, and where the
/// run's density nowhere crosses the mean.
std::optional<Shock> shock_of(const TubeRun& run, const TubeScene& scene, int side);
/// The right one, else the left one.
std::optional<Shock> shock_of(const TubeRun& run, const TubeScene& scene);

/// The scene `tube` of the reader's own: chapter 4's, of this gas.
shocks::TubeKind relativistic_kind();

/// Marti & Mueller's problems, with p_R = 1e-8 in the first, and two cold streams of lorentz 20.
TubeScene problem(int which);
TubeScene streams(double lorentz = 20, double p = 1e-3, double gamma = 4.0 / 3);

}  // namespace sph::landau
