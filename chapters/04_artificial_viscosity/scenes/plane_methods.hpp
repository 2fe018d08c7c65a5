#pragma once
#include "chapters/04_artificial_viscosity/scenes/model.hpp"

/// The methods in two dimensions, by name.
namespace sph {

/// Artificial viscosities: `none-cubic` and `signal-cubic`, which show why the others have another kernel;
/// `none`, `alpha-beta`, `signal`, `balsara`, `colagrossi`, and the recommended one, `reconstructed`, as the
/// last.
const std::vector<Method>& plane_methods();
/// Real viscosities: `pairwise`   (8.9) and `stress`   (Chen 2017, 49).
const std::vector<Method>& viscous_methods();
/// The method of that name, of either kind. Throws std::invalid_argument.
const Method& plane_method(const std::string& name);

/// `n` particles in the box. gamma > 1; nu >= 0 is the KINEMATIC viscosity [length^2/time] of the real
/// viscosities, and of no effect on others. Throws std::invalid_argument for an unknown method.
std::unique_ptr<Model<2>> make_model(const Method& method, std::size_t n, double gamma, const Box<2>& box,
                                     int threads, double nu = 0);

}  // namespace sph
