#pragma once
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

/// Throws Unstable where the run leaves physics.
TubeRun run_relativistic_tube(const TubeScene& scene, const TubeMethod& method);

/// What is followed besides the errors of a TubeRun, where the right wave is a shock; else zeros.
struct Shock {
    double place = 0;  ///< where the outermost density of the right wave crosses the mean of both its sides
    double error = 0;  ///< relative to its exact place
    double peak = 0;   ///< largest density behind it over the exact one
};
Shock shock_of(const TubeRun& run, const TubeScene& scene);

/// The scene `tube` of the reader's own: chapter 4's, of this gas.
shocks::TubeKind relativistic_kind();

/// Marti & Mueller's problems, with p_R = 1e-8 in the first, and two cold streams of lorentz 20.
TubeScene problem(int which);
TubeScene streams(double lorentz = 20, double p = 1e-3, double gamma = 4.0 / 3);

}  // namespace sph::landau
