#include "chapters/05_tensile_instability/scenes/lagrangian_solid.hpp"

#include "chapters/03_euler_sph/forces.hpp"
#include "chapters/05_tensile_instability/scenes/solid_laws.hpp"

namespace sph::tensile {

std::unique_ptr<Solid> make_lagrangian_solid(const SolidSetup& setup, const SolidMethod& method) {
    const auto smoothing = smoothing_of(setup, method);
    if (setup.box) return std::make_unique<LagrangianSolid<Box<2>>>(setup, smoothing, *setup.box);
    return std::make_unique<LagrangianSolid<Free>>(setup, smoothing, Free{});
}

std::unique_ptr<Solid> make_loaded_solid(const SolidSetup& setup, double friction) {
    using Loaded = LagrangianSolid<Free, Damping, GivenForce>;
    return std::make_unique<Loaded>(setup, smoothing_of(setup, solid_methods().recommended()), Free{},
                                    Damping{friction}, GivenForce{});
}

}  // namespace sph::tensile
