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

/// The recommended method, stored with 24 bits; `total`: what is stored is v^2/2 + u in the place of u.
Method<1> single_precision_energy(bool total);

/// In the plane: `inutsuka`, the paper's scheme with C_smooth = 1, `first-order`, the recommended one without
/// slopes, and `godunov`, which is that of the line with the paper's Gaussian: the narrow kernel's sums are
/// exact on a line only.
const Methods<2>& plane_methods();
/// In space: `first-order` and `godunov`.
const Methods<3>& space_methods();
/// Chapter 4's recommended dissipation in space.
Method<3> reconstructed_in_space();

}  // namespace sph::godunov
