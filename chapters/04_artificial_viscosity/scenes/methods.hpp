#pragma once
#include "chapters/03_euler_sph/equation_of_state.hpp"
#include "common/core/boundary.hpp"
#include "common/core/simulation.hpp"
#include "common/report/method.hpp"

/// Ways to run a gas, as values: a scene takes one and makes its gas of it. Later chapters add their own, and
/// run them in the same scenes.
namespace sph::shocks {

/// What a scene gives to any method.
template <int d>
struct Setup {
    std::size_t n;       ///< particles
    ThermalState state;  ///< of the gas
    Box<d> box;
    double courant = 0.45;  ///< step over the shortest time between neighbours
    int threads = 1;
};
template <int d>
using Method = report::Method<Simulation<d>, Setup<d>>;
template <int d>
using Methods = report::Methods<Method<d>>;

/// In one dimension, from the oldest to the recommended one.
const Methods<1>& tube_methods();
/// Those that dissipate, without the variants that change one thing at another.
std::vector<Method<1>> tube_contestants();
/// The viscosity of Monaghan & Gingold (1983) with the kernels that it was tried with.
const Methods<1>& kernel_methods();
/// Artificial viscosities in the plane: `none-cubic` and `signal-cubic`, which show why the others have
/// another kernel, and `none`, `alpha-beta`, `signal`, `balsara`, `colagrossi`, `reconstructed`.
const Methods<2>& plane_methods();
/// Real viscosities in the plane, with the parameter nu: `pairwise`   (8.9) and `stress`   (Chen 2017, 49).
const Methods<2>& viscous_methods();
/// Real viscosities where each particle has its own, in the column DynamicViscosity, which the scene fills:
/// `layered`   (8.9) and `layered-arithmetic`, the same with the mean that does not keep stress continuous.
const Methods<2>& layered_methods();

}  // namespace sph::shocks
