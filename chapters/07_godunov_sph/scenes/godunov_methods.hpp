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

}  // namespace sph::godunov
