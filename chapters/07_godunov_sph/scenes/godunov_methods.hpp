#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"

/// Godunov SPH as methods of chapter 4's scenes.
namespace sph::godunov {

using shocks::Method;
using shocks::Methods;
using shocks::Setup;

/// In one dimension: the paper's scheme as `inutsuka` (and with its options -linear, -first), what repairs it
/// one at a time (`careful`, `own-width`, `limited`, `narrow-faces`, `varying-h`), the recommended one,
/// `godunov`, and variants of it.
const Methods<1>& line_methods();
/// The paper's scheme with one h > 0 for all [length].
Method<1> same_h(double h);
/// The paper's scheme, stored with 24 bits.
Method<1> single_precision();

/// The recommended method, whose first `steps` >= 0 steps are done without slopes.
Method<1> with_calm_start(long steps);
/// The recommended method, stored with 24 bits; `total`: what is stored is v^2/2 + u in the place of u.
Method<1> single_precision_energy(bool total);

/// In the plane: `inutsuka`, the paper's scheme with C_smooth = 1; `godunov`, the sides, the solver and the
/// steps of the line's recommended one with the paper's Gaussian and V cubic (the narrow kernel's sums are
/// exact, and h varies along the pair's line only, on a line); and it without slopes (`first-order`), with
/// half steps as on a line (`along-line`) and with h between the particles (`geometric-volume`).
const Methods<2>& plane_methods();
/// In space: `godunov`.
const Methods<3>& space_methods();
/// Chapter 4's recommended dissipation in space.
Method<3> reconstructed_in_space();

}  // namespace sph::godunov
