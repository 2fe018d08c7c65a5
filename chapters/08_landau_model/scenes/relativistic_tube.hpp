#pragma once
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/exact/relativistic_riemann.hpp"

/// A tube of relativistic gas with baryons, c = 1: chapter 4's scene, with rest densities.
namespace sph {

/// The methods, from the classical to the recommended one, which is the last; a Method's h_over_dx is sigma
/// of chapter 3's HRule.
const std::vector<Method>& relativistic_methods();
/// Throws std::invalid_argument for an unknown name.
const Method& relativistic_method(const std::string& name);

/// What is followed besides the errors of a TubeRun.
struct RelativisticTubeRun : TubeRun {
    double shock = 0;  ///< where the outermost density of the right wave crosses the mean of both its sides
    double shock_error = 0;  ///< relative to its exact place; 0 where the right wave is no shock
    double shell_peak = 0;   ///< largest density behind that shock over the exact one
};

/// Runs the scene: `n` particles of equal baryon number (lab-frame density times length) in |x| < 0.5.
/// rho, v, p of scene.left, scene.right are rest density, velocity in (-1, 1) and pressure; gamma in (1, 2].
/// Throws Unstable where the run leaves physics, and std::invalid_argument for scenes that are none: among
/// them gas so cold that its heat is lost beside its energy, p/rho below 1e-13 lorentz^2.
RelativisticTubeRun run_relativistic_tube(const TubeScene& scene, const Method& method);

/// Fills shock, shock_error and shell_peak from a profile of the whole tube.
void look_at_shock(RelativisticTubeRun& run, const Profile& all, const TubeScene& scene,
                   const exact::RelativisticRiemann& solution);
/// The exact solution of the scene.
exact::RelativisticRiemann relativistic_solution(const TubeScene& scene);

}  // namespace sph
